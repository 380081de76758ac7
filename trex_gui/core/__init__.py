"""Shared by all devices. No Qt, and nothing of a particular device."""
