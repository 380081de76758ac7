"""Pages and dialogs of an Aracna."""
