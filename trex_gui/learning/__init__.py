"""What samples of the channel inputs mean: rest, travel, the calibration that fits them."""
