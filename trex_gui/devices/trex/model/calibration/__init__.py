"""The channel calibrations with their edits."""
