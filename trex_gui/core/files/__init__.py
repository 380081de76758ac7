"""Text files that users write: read whole, written whole, errors by line."""
