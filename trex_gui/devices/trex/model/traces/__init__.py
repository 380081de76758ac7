"""The curves that a board gives."""
