"""Windows for settings files."""
