"""The page *Board*: the board drawn as it is now."""
