"""Page that shows every packet on the line."""
