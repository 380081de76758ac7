"""Page on which the user moves the robot."""
