"""Qt objects that mirror the robot."""
