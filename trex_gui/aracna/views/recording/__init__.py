"""Recordings of an Aracna as a person looks at them."""
