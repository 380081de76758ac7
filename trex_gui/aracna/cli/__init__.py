"""`trexcmd aracna …`: ask an Aracna, move it, play pose files. No Qt."""
