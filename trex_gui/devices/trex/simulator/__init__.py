"""Simulated TReX or TReX Jr.

The simulator shares the tables of parameters and calibrations with the protocol package. It has its
own packet parser and checksum, so the two sides cannot contain the same mistake.
"""
