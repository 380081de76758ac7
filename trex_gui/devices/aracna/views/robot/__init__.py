"""The page on which the robot is seen and moved."""
