"""Dialogs that preview changes to settings: review, load, compare and convert."""
