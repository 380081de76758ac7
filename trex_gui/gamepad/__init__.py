"""Gamepads: reading them, and what their sticks and buttons mean. No Qt, nothing of the line."""
