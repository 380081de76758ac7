"""Reasons of the system to stop motors: signals, sleep, locked screen, uncaught exceptions."""
