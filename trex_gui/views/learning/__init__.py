"""Learning channels from what a person does with the sticks, and testing the result."""
