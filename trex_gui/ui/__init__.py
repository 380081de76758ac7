"""Shared by all devices, with Qt."""
