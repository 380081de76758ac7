"""Recording, and looking at recordings."""
