"""Qt objects that mirror the board. No widgets, no I/O."""
