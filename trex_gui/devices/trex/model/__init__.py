"""Qt objects that mirror the board. They contain no widgets and delegate I/O to other threads."""
