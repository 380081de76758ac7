"""The place *Diagnostics*: problems, log and traffic of a device."""
