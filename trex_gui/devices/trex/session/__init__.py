"""Session loop of a line to a TReX."""
