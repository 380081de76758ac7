"""Comparison of generated text with its last reviewed version."""

import difflib
from pathlib import Path


def assert_matches_golden(text: str, golden: Path, folder: Path) -> None:
    """Compare a text with a file. A failure shows the difference and how to accept it."""
    new = folder / golden.name
    new.write_bytes(text.encode("utf-8"))
    old = golden.read_bytes().decode("utf-8") if golden.exists() else ""
    difference = list(difflib.unified_diff(old.splitlines(), text.splitlines(), lineterm=""))
    hint = f"To accept the change: cp {new} {golden}"
    assert text == old, "\n".join([*difference, hint])
