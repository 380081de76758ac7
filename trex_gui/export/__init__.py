"""Export as code: settings and the line in force as a program that stands alone."""
