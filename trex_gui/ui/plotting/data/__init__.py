"""Samples in bounded memory, reduced to what a plot can show."""
