"""One package for each supported device; they never import each other."""
