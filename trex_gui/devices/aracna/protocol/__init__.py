"""Wire format of Aracna: commands, replies, units and joints."""
