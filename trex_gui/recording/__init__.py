"""Recordings of a session: what they hold, how they lie in a file, and reading them back."""
