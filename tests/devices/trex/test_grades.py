"""Grades of evidence in sentences with inferred or twin facts."""

import re
from collections.abc import Iterator
from functools import cache

import click
import pytest

from tests.support.scripts import program_texts
from trex_gui.devices.trex.plugin import TREX
from trex_gui.ui.help.pages import pages

FACTS = {
    "halfway between neutral and": "(inferred)",
    r"(above|below) about \{0\}": "(inferred)",
    "may be holding the motors|safe-start may hold": "(inferred)",
    r"until the channel is within about \{2\}": "(inferred)",
    "limit may have no effect|limiter does nothing": "(inferred)",
    "jumps back to (its )?full": "(inferred)",
    "PWM of motor .* runs at": "(inferred)",
    "motors may not run in RC mode": "(inferred)",
    "braked while its channel is within": "(inferred)",
    "make the motor pulse": "(inferred)",
    "restores? the serial settings (of|only)": "(inferred)",
    "calibrations do not change|keeps its calibrations": "(inferred)",
    "channel 3 six bits": "(inferred)",
    "counts as none: the channel gives 0|size of the value and not its sign": "(inferred)",
    "[Bb]eyond a limit that no document confirms": "(inferred)",
    "off by default": "(twin)",
    "on; by default it is": "(inferred)",
    "next motor command starts them again": "(inferred)",
    r"[Tt]imeout may (not stop|need)|It may need UART|may disable the Serial": "(twin)",
    "Shutdown is off: motors may": "(twin)",
    "[Cc]urrents (wrong|may be off) by 20 %": "(twin)",
    "[^.]0 switches it off|limit to 0": "(twin)",
}
"""Pattern of such a sentence, and the grade of its fact."""

_NOTATIONS = re.compile(
    r"inferred limits?|limits that are inferred|twin, inferred|\(inferred\)|\(twin\)", re.IGNORECASE
)


@cache
def sentences() -> tuple[str, ...]:
    """Return all sentences of the window, the help and `trexcmd --help`."""
    return tuple(sentence for text in _texts() for sentence in re.split(r"(?<=[.!?])\s+|\|", text))


def _texts() -> Iterator[str]:
    yield from sorted({source for source, _comment in program_texts()})
    for page in pages():
        yield from re.sub(r"\]\(\S+\)", "]", page.text).splitlines()
    for info in TREX.commands.values():
        command: click.Command = info.command.load()
        yield from (" ".join(part.split()) for part in (command.help or "").split("\n\n"))
        yield from (option.help or "" for option in command.params if hasattr(option, "help"))


@pytest.mark.parametrize(("fact", "grade"), FACTS.items())
def test_sentence_shows_the_grade_of_its_fact(fact: str, grade: str) -> None:
    matching = [sentence for sentence in sentences() if re.search(fact, sentence)]
    assert matching, "the pattern matches no sentence"
    assert [sentence for sentence in matching if grade not in sentence] == []


def test_grades_have_only_these_notations() -> None:
    remainders = (_NOTATIONS.sub("", sentence) for sentence in sentences())
    assert [sentence for sentence in remainders if re.search("(?i)inferred|twin", sentence)] == []
