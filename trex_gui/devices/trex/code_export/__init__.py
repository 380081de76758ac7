"""Settings as programs in C, Python and for Arduino."""
