"""One package for each supported device. They never import each other."""
