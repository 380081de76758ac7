"""The wizard that learns channels."""
