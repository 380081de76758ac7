"""Worker threads for lines, scans, files and recordings."""
