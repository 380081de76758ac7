"""The page of all parameters."""
