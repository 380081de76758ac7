"""Learning channels from the sticks, step by step."""
