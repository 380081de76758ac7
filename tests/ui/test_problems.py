"""Problems page of a device."""

from collections.abc import Sequence
from datetime import datetime
from types import SimpleNamespace
from typing import Any, cast

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from trex_gui.ui.diagnostics.problems import Problem, ProblemsPage, Reading
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.scroll_box import ScrollBox


class Page(ProblemsPage):
    def problems(self) -> Sequence[Problem]:
        text = "A stop bit was missing: the baud rates differ, or the line is noisy. "
        return [Problem(key, "Framing error", 3 * text, "1 time") for key in ("one", "two")]

    def since(self) -> datetime | None:
        return datetime(2026, 1, 1)  # noqa: DTZ001 - local

    def readings(self) -> Sequence[Reading]:
        return [Reading("Reads per second", "200")]


@pytest.mark.parametrize("height", [280, 440, 600])
def test_low_page_cuts_no_text(height: int, qtbot: QtBot, qapp: QApplication) -> None:
    theme().install(qapp)
    traffic = SimpleNamespace(everything=SimpleNamespace(rows=[]))
    page = Page("errors", cast("Any", traffic), cast("Any", None))
    box = ScrollBox(page)
    qtbot.addWidget(box)
    box.resize(800, height)
    box.show()
    page.refresh()
    text = page.findChild(QLabel, "oneText")
    assert text is not None
    QTest.qWait(0)
    assert text.width() > 400, "it is laid out"
    assert text.height() >= text.heightForWidth(text.width()) > text.fontMetrics().height()
