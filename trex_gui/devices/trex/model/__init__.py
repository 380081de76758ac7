"""Qt objects that mirror the board; no widgets, no I/O."""
