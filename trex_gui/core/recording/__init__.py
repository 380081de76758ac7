"""Recordings of a session on disk."""
