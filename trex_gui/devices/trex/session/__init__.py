"""Session of a line: the loop that runs all transactions with its boards."""
