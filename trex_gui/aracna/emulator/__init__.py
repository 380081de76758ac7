"""The simulated robot: firmware, servos, its UART and wire. Written from the documents alone."""
