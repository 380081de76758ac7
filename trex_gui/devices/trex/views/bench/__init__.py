"""The window of bench tests."""
