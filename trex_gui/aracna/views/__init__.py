"""What people see and touch of Aracna; holds no state of the robot, does no I/O."""
