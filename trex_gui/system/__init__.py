"""Events of the operating system that stop motors: signals, sleep, screen lock."""
