"""Curves over time: how they are kept, thinned for a picture and summed up."""
