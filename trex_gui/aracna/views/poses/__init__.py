"""The part of the page that keeps poses, sequences and gaits, and plays them."""
