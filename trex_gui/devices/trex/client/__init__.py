"""Client for a TReX: transactions, and reads and writes of its settings."""
