"""Bench tests: what a motor is made to do, what came of it, and the figures to judge it by."""
