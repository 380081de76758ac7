"""Process that stops the motors when the program does not respond."""
