"""The place *Diagnostics*: problems, log and traffic of a device, with one head for all."""
