"""Threads of the program, for lines, scans, files and recordings."""
