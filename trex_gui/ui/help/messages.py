"""Help topics for coded messages and for the focused widget."""

import re
from collections.abc import Iterable, Mapping
from enum import Enum
from functools import cache

from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.help.pages import INDEX, MESSAGES, anchor_of

_FIELD = re.compile(r"\{\w*(?::[^}]*)?\}")


def heading_of(text: str) -> str:
    """Return the first clause of a message. Each field becomes `…`."""
    whole = re.sub(r"^(…: |… (?=[A-Z]))", "", _FIELD.sub("…", text))
    clause = re.split(r"[.:;](?:\s|$)", whole)[0].strip()
    return clause[:1].upper() + clause[1:] if clause != "…" else ""


def message_topic(text: str) -> str:
    """Return the help topic for an English message."""
    return f"{MESSAGES}#{anchor_of(heading_of(text))}"


class MessageHelp:
    """Help topics for the messages of a device, in the language of the window."""

    def __init__(self, texts: Iterable[str]) -> None:
        """`texts`: English messages, with a placeholder for each field."""
        self._texts = tuple(texts)

    def headings(self) -> dict[str, str]:
        """Return topic → translated heading."""
        return {
            message_topic(text): heading_of(tr(text)) for text in self._texts if heading_of(text)
        }

    def topic(self, message: str) -> str:
        """Return the topic for a message or log line. Empty if no text matches."""
        # A long text may contain a shorter text.
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
    return [str(code.value) for code in codes]


def focused_topic(topics: Mapping[str, str], page: QWidget | None) -> str:
    """Return the help topic of the focused widget. Otherwise return the topic of the page.

    `topics`: object name → topic.
    """
    widget = QApplication.focusWidget() or QApplication.activeWindow()
    while widget is not None:
        if widget.objectName() in topics:
            return topics[widget.objectName()]
        widget = None if widget.isWindow() else widget.parentWidget()
    return topics.get(page.objectName().removesuffix("Area") if page is not None else "", INDEX)
