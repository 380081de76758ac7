"""A process of its own that stops the motors when the program does not respond."""
