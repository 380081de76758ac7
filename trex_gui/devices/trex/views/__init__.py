"""Pages and dialogs of a TReX."""
