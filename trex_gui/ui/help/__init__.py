"""Built-in help: pages, window, search, and topics for messages."""
