"""What travels between a computer and Aracna: lines, replies, units, joints. No I/O, no clock."""
