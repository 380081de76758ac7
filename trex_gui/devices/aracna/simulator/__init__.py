"""Simulated Aracna: firmware, servos, UART and wire."""
