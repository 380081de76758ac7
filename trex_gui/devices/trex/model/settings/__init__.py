"""Settings: files, edits, comparison, history and writes."""
