"""Finding a TReX whose line settings are unknown, without moving a motor."""
