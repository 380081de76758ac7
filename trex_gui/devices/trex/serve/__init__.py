"""Boards that are served over a network. The session runs on the robot's computer."""
