"""One package for each supported device. These packages never import each other."""
