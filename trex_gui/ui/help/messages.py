"""Sections of the help on messages that have a code, and on the widget with the focus."""

import re
from collections.abc import Iterable, Mapping
from enum import Enum
from functools import cache

from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.help.pages import INDEX, MESSAGES, anchor_of

_FIELD = re.compile(r"\{\w*(?::[^}]*)?\}")


def heading_of(text: str) -> str:
    """Return the heading of the section on a message.

    It is the first clause, with … for each field. Empty if the message has no words of its own.
    """
    whole = re.sub(r"^(…: |… (?=[A-Z]))", "", _FIELD.sub("…", text))
    clause = re.split(r"[.:;](?:\s|$)", whole)[0].strip()
    return clause[:1].upper() + clause[1:] if clause != "…" else ""


def message_topic(text: str) -> str:
    """Return the help topic on a message, which is given in English."""
    return f"{MESSAGES}#{anchor_of(heading_of(text))}"


class MessageHelp:
    """Finds the help on messages of a device, in the language of the window."""

    def __init__(self, texts: Iterable[str]) -> None:
        """`texts`: messages in English, with a placeholder for each field."""
        self._texts = tuple(texts)

    def headings(self) -> dict[str, str]:
        """Return the heading of each message in the language of the window, by topic."""
        found = ((heading_of(text), heading_of(tr(text))) for text in self._texts)
        return {f"{MESSAGES}#{anchor_of(own)}": shown for own, shown in found if own}

    def topic(self, message: str) -> str:
        """Return the topic on a message or a line of the log. Empty if no text matches.

        Of several matching texts the longest counts, since it contains the other texts.
        """
        return max(self._matches(message), default=(0, ""))[1]

    def _matches(self, message: str) -> Iterable[tuple[int, str]]:
        line = " ".join(message.split())
        for text in self._texts:
            size, pattern = _pattern(tr(text))
            if pattern.search(line) and heading_of(text):
                yield size, message_topic(text)


@cache
def _pattern(text: str) -> tuple[int, re.Pattern[str]]:
    """Return the length of a text without its fields, and a pattern that finds the text."""
    parts = _FIELD.split(" ".join(text.split()).rstrip(". "))
    pattern = ".+?".join(map(re.escape, parts)).removeprefix(".+?").removesuffix(".+?")
    return sum(map(len, parts)), re.compile(pattern)


def texts_of(codes: Iterable[Enum]) -> list[str]:
    """Return the texts of codes, which are the values of the codes."""
    return [str(code.value) for code in codes]


def topic_in_front(topics: Mapping[str, str], page: QWidget | None) -> str:
    """Return the topic of the focused widget, else of a page. `topics`: object name → topic."""
    widget = QApplication.focusWidget() or QApplication.activeWindow()
    while widget is not None:
        if widget.objectName() in topics:
            return topics[widget.objectName()]
        widget = None if widget.isWindow() else widget.parentWidget()
    return topics.get(page.objectName().removesuffix("Area") if page is not None else "", INDEX)
