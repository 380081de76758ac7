"""The transcript of a line: its table, what one row says in full, and files of it."""
