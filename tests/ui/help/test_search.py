"""Search with typical queries in each language of the window."""

import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

from tests.support.catalogs import in_language
from tests.support.window import WindowDriver
from trex_gui.ui.help.search import Findable, SearchIndex

QUESTIONS = tomllib.loads(Path(__file__).with_name("questions.toml").read_text(encoding="utf-8"))
MAX_HITS, MIN_SHARE = 3, 0.95


@pytest.fixture(params=QUESTIONS)
def language(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[str]:
    with in_language(qapp, QLocale(request.param)):
        yield request.param


def test_typical_questions_are_answered(language: str, window: WindowDriver) -> None:
    index = SearchIndex(window.window.findables())

    questions: dict[str, str] = QUESTIONS[language]

    def is_answered(question: str) -> bool:
        hits = {f"{hit.kind}:{hit.key}" for hit in index.find(question)[:MAX_HITS]}
        return not hits.isdisjoint(questions[question].split())

    missed = [question for question in questions if not is_answered(question)]
    assert len(missed) <= (1 - MIN_SHARE) * len(questions), missed


@pytest.mark.parametrize(
    ("typed", "title"),
    [
        ("curr", "Current Limit"),
        ("CURRENTS", "Current Limit"),
        ("curent limit", "Current Limit"),
        ("grenze", "Current Limit"),
        ("Wechsel", "Richtungswechsel"),
        ("duree", "Durée de freinage"),
        ("polymotor1", ""),
    ],
)
def test_search_finds_parts_word_forms_synonyms_and_misspellings(typed: str, title: str) -> None:
    titles = ["Current Limit", "Richtungswechsel", "Durée de freinage", "Restore factory defaults"]
    index = SearchIndex([Findable("action", str(n), title) for n, title in enumerate(titles)])
    assert [hit.title for hit in index.find(typed)[:1]] == [title] * bool(title)


def test_pasted_message_finds_its_section_first(window: WindowDriver) -> None:
    index = SearchIndex(window.window.findables())
    for message, title in (
        ("Serial Timeout: the board rejects this value (code 2)", "The board rejects this value"),
        ("A TReX responds on X with CRC polynomial 0x89, but this connection uses 0x8B.", "A … r"),
        (
            "Nothing was sent, because a stop was requested first.",
            "Nothing was sent, because a stop",
        ),
    ):
        assert index.find(message)[0].title.startswith(title)
