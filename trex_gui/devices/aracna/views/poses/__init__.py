"""Editing and playing poses, sequences and gaits."""
