"""Transactions with a TReX, and reading and writing of its settings."""
