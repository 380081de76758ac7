"""Operating system events that stop motors: signals, sleep, a locked screen."""
