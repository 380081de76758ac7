"""Shared parts of line sessions: loop, request queue and messages."""
