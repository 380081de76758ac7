"""The panel of the Demo TReX: what hands do to a board, for those who have none."""
