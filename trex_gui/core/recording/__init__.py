"""Recordings: SQLite files with one table per sample kind."""
