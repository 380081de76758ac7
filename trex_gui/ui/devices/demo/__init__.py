"""Panels of simulated devices."""
