"""The simulated board as the window handles it."""
