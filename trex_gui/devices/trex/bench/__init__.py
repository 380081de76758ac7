"""Bench tests: speed profiles, measured currents and figures."""
