"""The loop that owns a line to Aracna, one command in flight."""
