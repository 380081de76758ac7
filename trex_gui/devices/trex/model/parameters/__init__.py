"""Qt model of the parameters with their edits."""
