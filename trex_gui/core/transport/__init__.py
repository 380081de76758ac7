"""Serial ports: opening, ownership, supported rates, traffic log."""
