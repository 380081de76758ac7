"""Simulated TReX or TReX Jr.

The tables of parameters and calibrations are shared with the protocol package. The packet parser
and the checksum are separate implementations, so that both ends cannot contain the same mistake.
"""
