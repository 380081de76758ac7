"""What the system tells a program that drives motors: signals, sleep, a locked screen, mistakes."""
