"""Making recordings and playing them back."""
