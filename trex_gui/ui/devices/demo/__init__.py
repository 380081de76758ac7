"""The panel of a simulated device."""
