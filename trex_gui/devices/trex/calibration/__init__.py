"""Calibration of channels from samples of their inputs."""
