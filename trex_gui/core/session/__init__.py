"""The frame of a session on one line: request queue and common messages."""
