"""Dialogs that preview changes of settings: review, load, compare, convert."""
