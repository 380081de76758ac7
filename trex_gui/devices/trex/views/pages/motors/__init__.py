"""Page for driving by hand."""
