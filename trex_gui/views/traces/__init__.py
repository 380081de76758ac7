"""Curves over time to look at: plot, cursors, figures, events, pictures and tables of them."""
