"""Serving a simulated device: endpoints, wire faults, control lines, virtual time."""
