"""TReX Studio: set up, calibrate, drive and understand a Pololu TReX motor controller."""

__version__ = "0.1.0"
