"""Recordings of a session: SQLite files with one table for each kind of sample."""
