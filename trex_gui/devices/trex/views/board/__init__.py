"""Board page."""
