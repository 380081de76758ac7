"""Page of poses, sequences and gaits."""
