"""The panel of the simulated TReX."""
