"""The thread around a line session: the one place where Qt meets the wire."""
