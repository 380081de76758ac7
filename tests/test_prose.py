"""Docstrings and function names follow the style rules."""

import ast
import re
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
Function = ast.FunctionDef | ast.AsyncFunctionDef
Documented = ast.Module | ast.ClassDef | Function

HOUSE_VERB = re.compile(r"_*(take|note|begin|make|ask|choose|keep|leave|forget|tell)(_|$)")
NOUNS = {"note"}  # a property of found devices
QUESTION = re.compile(r"(What|Whether|How|Why|Where)\b")


def first_sentence(docstring: str) -> str:
    paragraph = " ".join(docstring.split("\n\n", maxsplit=1)[0].split())
    end = re.search(r"[.!?](\s|$)", paragraph)
    return paragraph[: end.start()] if end else paragraph


def problems(place: str, node: Documented) -> Iterator[str]:
    docstring = ast.get_docstring(node)
    sentence = first_sentence(docstring) if docstring else ""
    if ";" in sentence:
        yield f"{place}: two thoughts in the first sentence: {sentence}"
    if QUESTION.match(sentence):
        yield f"{place}: opens with a question: {sentence}"
    if isinstance(node, Function) and HOUSE_VERB.match(node.name) and node.name not in NOUNS:
        yield f"{place}: not a standard verb: {node.name}"


@pytest.mark.parametrize("folder", ["packaging", "tests", "trex_gui"])
def test_docstrings_and_names_follow_the_rules(folder: str) -> None:
    found = [
        problem
        for path in sorted((ROOT / folder).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, Documented)
        for problem in problems(f"{path.relative_to(ROOT)}:{getattr(node, 'lineno', 1)}", node)
    ]
    assert found == []


def misplaced(source: str) -> list[int]:
    """Return the lines of signals and short constants that no comment behind the value describes.

    A longer description of a constant may follow as a docstring.
    """
    lines, found = source.splitlines(), []
    for node in ast.walk(ast.parse(source)):
        body = node.body if isinstance(node, ast.Module | ast.ClassDef) else []
        for value, below in pairwise([*body, ast.Pass()]):
            if not isinstance(value, ast.Assign):
                continue
            text = ""
            if isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
                text = str(below.value.value)
            line = lines[value.lineno - 1]
            if re.search(r"= Signal\(", line):
                above = lines[value.lineno - 2].strip() if value.lineno > 1 else ""
                is_misplaced = bool(text) or above.startswith("#")
            else:
                fits = value.lineno == value.end_lineno and len(f"{line}  # {text}") <= 100
                is_misplaced = bool(text) and "\n" not in text and fits
            if is_misplaced:
                found.append(value.lineno)
    return found


def test_signals_and_constants_are_described_behind_the_value() -> None:
    places = [
        f"{path.relative_to(ROOT)}:{line}"
        for folder in ("packaging", "trex_gui")
        for path in sorted((ROOT / folder).rglob("*.py"))
        for line in misplaced(path.read_text(encoding="utf-8"))
    ]
    assert places == []


@pytest.mark.parametrize(
    "source",
    [
        'changed = Signal()\n"""Short."""',
        'class A:\n    changed = Signal()\n    """One.\n\n    Two.\n    """',
        "# above\nchanged = Signal()",
        'LIMIT = 3\n"""Short."""',
        'class A:\n    LIMIT = 3\n    """Short."""',
    ],
)
def test_description_above_or_below_the_value_is_found(source: str) -> None:
    assert misplaced(source) != []


@pytest.mark.parametrize(
    ("docstring", "sentence"),
    [
        ("Return 1.5 V. Then more.", "Return 1.5 V"),
        ("A noun\n    over two lines; and more\n\nAnother.", "A noun over two lines; and more"),
    ],
)
def test_first_sentence_ends_with_its_full_stop(docstring: str, sentence: str) -> None:
    assert first_sentence(docstring) == sentence


@pytest.mark.parametrize(
    "source",
    ['"""One; two."""', 'class A:\n  """How to."""', "def take_board(): ...", "def _ask(): ..."],
)
def test_each_broken_rule_is_found(source: str) -> None:
    assert [
        found
        for node in ast.walk(ast.parse(source))
        if isinstance(node, Documented)
        for found in problems("here", node)
    ] != []
