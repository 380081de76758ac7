"""Docstrings and function names follow the style rules."""

import ast
import re
from collections.abc import Iterator
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


@pytest.mark.parametrize("folder", ["trex_gui", "tests"])
def test_docstrings_and_names_follow_the_rules(folder: str) -> None:
    found = [
        problem
        for path in sorted((ROOT / folder).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, Documented)
        for problem in problems(f"{path.relative_to(ROOT)}:{getattr(node, 'lineno', 1)}", node)
    ]
    assert found == []


def misplaced(path: Path) -> Iterator[str]:
    """Yield signals and short constants that are not described by a comment behind the value."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for node in ast.walk(ast.parse("\n".join(lines))):
        body = node.body if isinstance(node, ast.Module | ast.ClassDef) else []
        for value, below in zip(body, [*body[1:], None], strict=False):
            if not isinstance(value, ast.Assign):
                continue
            line = lines[value.lineno - 1]
            text = ""
            if isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
                text = str(below.value.value)
            fits = value.lineno == value.end_lineno and len(f"{line}  # {text}") <= 100
            is_signal = re.search(r"= Signal\(", line)
            above = lines[value.lineno - 2].strip() if is_signal and value.lineno > 1 else ""
            if above.startswith("#") or (text and "\n" not in text and (is_signal or fits)):
                yield f"{path.relative_to(ROOT)}:{value.lineno}"


def test_signals_and_constants_are_described_behind_the_value() -> None:
    paths = sorted((ROOT / "trex_gui").rglob("*.py"))
    assert [place for path in paths for place in misplaced(path)] == []


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
