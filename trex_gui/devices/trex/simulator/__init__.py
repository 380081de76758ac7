"""A virtual TReX or TReX Jr: the device's side of the wire.

What the board is and does (`firmware`), how it reads bytes (`uart`), the wire (`line`) and
real time (`server`) are things of their own; only the last knows a clock.

The tables of parameters and calibrations are shared with the protocol package. Decoding and the
checksum are not: written twice, from the documentation, one mistake cannot hide at both ends.
"""
