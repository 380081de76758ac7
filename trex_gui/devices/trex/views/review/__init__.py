"""Before and after a write: review, factory defaults, power cycle."""
