"""The window of bench tests: what is asked of a motor, what it drew, what to set otherwise."""
