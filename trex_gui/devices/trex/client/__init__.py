"""Client for a TReX: transactions, and access to its settings."""
