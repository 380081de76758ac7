"""Parameters of a board or file: values, edits and texts."""
