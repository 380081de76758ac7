"""The page to drive by hand."""
