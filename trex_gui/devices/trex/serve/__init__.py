"""Boards over a network. The session runs at the robot."""
