"""Ports, connections and simulated devices."""
