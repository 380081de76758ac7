"""Settings files: read, write, compare and check them, and keep a history."""
