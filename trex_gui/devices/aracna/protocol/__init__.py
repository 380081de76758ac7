"""Lines, replies, units and joints of Aracna. No I/O, no clock."""
