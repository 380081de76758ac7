"""Lines, replies, units and joints of Aracna; no I/O, no clock."""
