"""Boards over a network. The session runs at the robot, its messages cross the network."""
