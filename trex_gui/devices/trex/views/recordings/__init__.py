"""The window of a recording of a TReX."""
