"""Poses, sequences and gaits, and the files that they are kept in. No Qt."""
