"""The device in use and the ports that devices are on."""
