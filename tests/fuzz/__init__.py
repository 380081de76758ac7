"""Mutated and random input for everything that reads what other programs and devices wrote."""
