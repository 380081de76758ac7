"""The panel of the Demo Aracna: what hands do to a robot, for those who have none."""
