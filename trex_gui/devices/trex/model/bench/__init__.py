"""Bench tests on the board that is connected."""
