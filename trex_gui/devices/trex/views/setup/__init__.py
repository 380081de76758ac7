"""Assistant that sets up a robot."""
