"""Comparison of generated files with their last checked version."""

import difflib
from pathlib import Path


def assert_matches_golden(text: str, known: Path, folder: Path) -> None:
    """Compare a text with a file. The message shows the difference and how to accept it."""
    new = folder / known.name
    new.write_bytes(text.encode("utf-8"))
    old = known.read_bytes().decode("utf-8") if known.exists() else ""
    difference = list(difflib.unified_diff(old.splitlines(), text.splitlines(), lineterm=""))
    hint = f"If this is wanted: cp {new} {known}"
    assert text == old, "\n".join([*difference, hint])
