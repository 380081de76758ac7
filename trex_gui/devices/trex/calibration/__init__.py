"""From samples of the channel inputs to a calibration."""
