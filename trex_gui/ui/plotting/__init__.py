"""Curves over time. No other package imports pyqtgraph."""
