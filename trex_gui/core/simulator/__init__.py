"""Simulated devices: endpoints, wire faults, control lines, virtual time."""
