"""Identifiers use the terms of the field."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

PROGRAM = Path(__file__).parents[1] / "trex_gui"

REPLACED = {
    "advice": "finding",
    "alien": "other baud rate",
    "asked": "sent, requested",
    "calm": "quiet, LineQuality",
    "desk": "workspace",
    "furnish": "add_workspace",
    "gathered": "loaded",
    "insist": "retry",
    "odd": "warning",
    "owed": "unanswered, pending",
    "patience": "timeout",
    "proof": "confirmation",
    "proved": "confirmed",
    "resting": "idle",
    "rests": "is_idle",
    "seek": "scan, probe",
    "seeker": "prober",
    "seeks": "probers",
    "sighting": "found device",
    "spoil": "corrupt",
    "spoilt": "corrupted",
    "stands": "pending",
    "tape": "traffic log",
    "tell": "notify, report",
    "telling": "evidence",
    "tells": "reports",
    "told": "notified, reported",
    "twin": "other motor",
    "twins": "motor pair",
    "unproved": "unconfirmed",
    "verdict": "diagnosis",
    "whose": "identify",
    "wish": "setpoint",
    "wished": "setpoint",
    "wishes": "setpoints",
    "wording": "decoder, text",
}
"""Words that identifiers must not contain, and their replacements."""

EXCEPTIONS = {"ODD": "a parity", "TWIN": "a grade of evidence"}  # identifier → its meaning


def identifiers(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Yield each name that a module defines, and its line."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef() | ast.ClassDef():
                yield node.name, node.lineno
            case ast.arg():
                yield node.arg, node.lineno
            case ast.Name(ctx=ast.Store()):
                yield node.id, node.lineno
            case ast.Attribute(ctx=ast.Store()):
                yield node.attr, node.lineno


@cache
def words(name: str) -> list[str]:
    """Return the words of an identifier in lower case."""
    return [word.lower() for word in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name)]


@pytest.mark.parametrize("name", ["is_asked", "AskedTwice", "NOT_ASKED"])
def test_words_are_found_in_every_naming_style(name: str) -> None:
    assert "asked" in words(name)


def sources() -> Iterator[tuple[Path, str]]:
    """Yield the files that contain a forbidden word. Other files need no syntax tree."""
    for path in sorted(PROGRAM.rglob("*.py")):
        source = path.read_text(encoding="utf-8")
        if any(not REPLACED.keys().isdisjoint(words(name)) for name in re.findall(r"\w+", source)):
            yield path, source


def test_identifiers_avoid_replaced_words() -> None:
    found = [
        f"{path.relative_to(PROGRAM)}:{line}: {name} ({word}: say {REPLACED[word]})"
        for path, source in sources()
        for name, line in identifiers(ast.parse(source))
        for word in words(name)
        if word in REPLACED and name not in EXCEPTIONS
    ]
    assert found == []
