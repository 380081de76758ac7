"""Colours and icons: light, dark and high contrast."""
