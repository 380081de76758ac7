"""Commands of trexcmd for a TReX."""
