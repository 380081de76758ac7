"""Driving by hand: what a person wishes of the motors, and how it gets to the line."""
