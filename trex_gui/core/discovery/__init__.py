"""Search for devices on ports."""
