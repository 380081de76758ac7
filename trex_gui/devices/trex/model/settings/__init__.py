"""Settings as a whole: files, comparison, history, apply."""
