"""The loop that owns a line to a TReX."""
