"""Driving by hand: setpoints from sliders, pad, keys and gamepads."""
