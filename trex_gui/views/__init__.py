"""What people see and touch; holds no device state, does no I/O."""
