"""Fuzzing of all input from users, other programs and devices."""
