"""A simulated TReX or TReX Jr.

The tables of parameters and calibrations are shared with the protocol package. Decoding and
checksum are implemented again from the documentation, so that one mistake cannot hide at both ends.
"""
