"""What a recording of a TReX holds."""
