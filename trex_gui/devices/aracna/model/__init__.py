"""Qt models of the robot."""
