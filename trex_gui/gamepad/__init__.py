"""Gamepads: reading them, and what their sticks and buttons mean."""
