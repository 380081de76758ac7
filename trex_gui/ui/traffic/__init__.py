"""The page that shows every packet on the line."""
