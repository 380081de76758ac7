"""Layout of the Problems page."""

from collections.abc import Sequence
from datetime import datetime
from types import SimpleNamespace
from typing import Any, cast

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from trex_gui.ui.diagnostics.problems import Problem, ProblemsPage, Reading
from trex_gui.ui.widgets.scroll_box import ScrollBox


class SampleProblemsPage(ProblemsPage):
    def problems(self) -> Sequence[Problem]:
        text = "A stop bit was missing: the baud rates differ, or the line is noisy. "
        return [Problem(key, "Framing error", 3 * text, "1 time") for key in ("first", "second")]

    def since(self) -> datetime | None:
        return datetime(2026, 1, 1)  # noqa: DTZ001 - local time

    def readings(self) -> Sequence[Reading]:
        return [Reading("Reads per second", "200")]


@pytest.mark.parametrize("height", [280, 440, 600])
def test_text_is_not_cut_off_on_a_low_page(height: int, qtbot: QtBot) -> None:
    traffic = SimpleNamespace(everything=SimpleNamespace(rows=[]))
    page = SampleProblemsPage("errors", cast("Any", traffic), cast("Any", None))
    box = ScrollBox(page)
    qtbot.addWidget(box)
    box.resize(800, height)
    box.show()
    page.refresh()
    text = page.findChild(QLabel, "firstText")
    assert text is not None
    QTest.qWait(0)
    assert text.width() > 400, "the page has been laid out"
    assert text.height() >= text.heightForWidth(text.width()) > text.fontMetrics().height()
