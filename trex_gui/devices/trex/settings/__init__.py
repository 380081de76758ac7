"""Settings files: reading, writing, comparing, checking, history."""
