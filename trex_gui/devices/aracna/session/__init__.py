"""Session with an Aracna."""
