"""The parameters with their edits, as a Qt model."""
