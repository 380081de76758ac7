"""The simulated Aracna: firmware, servos, UART and wire."""
