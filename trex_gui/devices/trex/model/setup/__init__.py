"""Setting a robot up step by step."""
