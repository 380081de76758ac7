"""The commands `trexcmd aracna`."""
