"""The assistant that sets up a robot."""
