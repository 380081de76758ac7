"""Serial ports: opening and guarding them, their baud rates, and their traffic."""
