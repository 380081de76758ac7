"""The history of a board's settings: looking back, comparing, bringing back."""
