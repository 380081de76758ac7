"""What every command line shares: messages, errors, progress, common options."""
