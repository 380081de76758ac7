"""Serial ports, with their guardian, supported baud rates and traffic."""
