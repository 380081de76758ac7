"""Window for bench tests."""
