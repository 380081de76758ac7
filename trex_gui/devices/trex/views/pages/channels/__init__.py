"""The page on which channels are calibrated."""
