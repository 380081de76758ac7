"""Parts of all simulators: endpoints, wire faults, control lines, virtual time."""
