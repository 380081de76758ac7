"""Finding devices on ports: what a prober offers, and the scan over ports."""
