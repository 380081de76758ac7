"""One transaction at a time with a TReX, and what is read and written with them."""
