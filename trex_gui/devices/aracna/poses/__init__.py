"""Poses, sequences, gaits and their files."""
