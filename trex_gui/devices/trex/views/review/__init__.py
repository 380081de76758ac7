"""After a write: the power cycle."""
