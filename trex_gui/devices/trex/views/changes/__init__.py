"""Changes of settings before they are made: review, load, compare, convert, several boards."""
