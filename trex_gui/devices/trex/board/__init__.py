"""The mirror of one board, and the one transaction for writes: no Qt, no threads."""
