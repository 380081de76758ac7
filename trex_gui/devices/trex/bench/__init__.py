"""Bench tests: speed profile, measured current, figures."""
