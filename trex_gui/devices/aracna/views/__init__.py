"""Pages and dialogs of Aracna."""
