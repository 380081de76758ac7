"""Talking to Aracna: one command in flight, a session, finding it. No Qt."""
