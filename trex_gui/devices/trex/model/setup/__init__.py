"""Robot setup, step by step."""
