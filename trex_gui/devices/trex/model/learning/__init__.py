"""Learning of channels from stick movements."""
