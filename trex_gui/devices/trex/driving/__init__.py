"""Motor output on the line: setpoints, arming, stops and their confirmation."""
