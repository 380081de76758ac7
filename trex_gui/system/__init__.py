"""Operating system events that stop the motors: signals, sleep, screen lock."""
