"""Finding an Aracna on a port, without moving it."""
