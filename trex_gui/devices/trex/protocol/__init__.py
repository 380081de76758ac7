"""The TReX on the wire: pure functions and frozen data. No I/O, no clock, no Qt."""
