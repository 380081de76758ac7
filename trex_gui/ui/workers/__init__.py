"""The threads of the program: lines, scans, files and recordings."""
