"""Page of all parameters."""
