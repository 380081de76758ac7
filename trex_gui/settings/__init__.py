"""Settings files: what a board keeps, as text that people read, compare and edit."""
