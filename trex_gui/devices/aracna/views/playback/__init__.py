"""The window of a recording of Aracna."""
