"""The board over a network: the session stays at the robot, its requests and reports travel."""
