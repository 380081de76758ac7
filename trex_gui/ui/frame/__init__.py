"""The main window around the workspace of a device."""
