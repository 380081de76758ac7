"""Shared by all devices; no Qt, and nothing of a particular device."""
