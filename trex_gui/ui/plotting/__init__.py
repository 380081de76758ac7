"""Curves over time; the only package that imports pyqtgraph."""
