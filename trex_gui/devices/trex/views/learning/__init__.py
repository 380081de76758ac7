"""Assistant that learns channels."""
