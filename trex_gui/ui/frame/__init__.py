"""Main window around the workspace of a device."""
