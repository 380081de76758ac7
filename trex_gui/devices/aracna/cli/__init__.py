"""Commands of `trexcmd aracna`."""
