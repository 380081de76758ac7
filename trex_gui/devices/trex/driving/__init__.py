"""Motor output: setpoints, arming, and stops with their confirmation."""
