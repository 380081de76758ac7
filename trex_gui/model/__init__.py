"""Qt objects that mirror the device and announce what changed; no widgets, no I/O."""
