"""Session with an Aracna: one command in flight on one line."""
