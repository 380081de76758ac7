"""The TReX on the wire: pure functions and frozen data; no I/O, no clock, no Qt."""
