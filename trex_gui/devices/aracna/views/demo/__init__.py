"""The panel of the simulated Aracna."""
