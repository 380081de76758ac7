"""Fuzzing of all input from other programs and devices."""
