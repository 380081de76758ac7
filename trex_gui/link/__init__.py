"""From commands to a real line: ports, transactions, and the loop that owns a line. No Qt."""
