"""Before and after something is written: what will be, how it went, how it becomes active."""
