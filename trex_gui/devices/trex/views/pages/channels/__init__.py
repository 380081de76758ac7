"""The page of the live channel bars."""
