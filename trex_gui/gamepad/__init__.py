"""Gamepads, and the functions of their sticks and buttons."""
