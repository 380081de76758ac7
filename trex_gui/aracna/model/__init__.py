"""Aracna as the window sees it: Qt objects that mirror the robot."""
