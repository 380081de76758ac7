"""Settings files in windows of their own, with and without a board."""
