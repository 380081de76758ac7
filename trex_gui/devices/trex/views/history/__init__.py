"""The history of a board's settings."""
