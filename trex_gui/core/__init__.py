"""Code that all devices share, without Qt."""
