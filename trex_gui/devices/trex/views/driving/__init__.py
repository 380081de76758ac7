"""Controls that drive while they are held: keys, gamepads."""
