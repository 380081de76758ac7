"""What goes over the line, as a person sees it: of a board, and of nothing else."""

import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QCheckBox,
    QFileDialog,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.views.transcript.page import TranscriptPage
from trex_gui.views.transcript.table import RECEIVED, SENT, WORDS
from trex_gui.views.transcript.table_view import TranscriptView
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

WidgetT = TypeVar("WidgetT", bound=QWidget)
LEFT = Qt.MouseButton.LeftButton


class Reader:
    """Somebody who looks at the transcript of a simulated board."""

    def __init__(self, program: Program, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.program, self.device, self.window = program, program.device, program.window
        self.simulator, self.qtbot = simulator, qtbot
        pages = self.window.pages
        pages.setCurrentIndex(pages.count() - 1)
        self.page = self.find(TranscriptPage, "transcriptPage")
        self.view = self.find(TranscriptView, "transcriptView")

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        found = self.window.findChild(kind, name)
        assert isinstance(found, kind), name
        return found

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=15_000)

    def connect(self) -> None:
        self.device.connect_to(LinkSettings(self.simulator.url))
        self.wait(lambda: self.device.link is Link.UP)

    def column(self, column: int) -> list[str]:
        """What is written in a column, from the top."""
        model = self.view.model()
        return [str(model.index(row, column).data()) for row in range(model.rowCount())]

    def row_of_the_signature(self) -> int:
        """Where it was asked for; where an answer was late, the last time."""
        sent = self.column(SENT)
        return max(row for row in range(len(sent)) if sent[row] == "81")

    def waits_for(self, text: str) -> None:
        """Wait until a row says this."""
        self.wait(lambda: any(text in words for words in self.column(WORDS)))

    def tick(self, name: str, on: bool = True) -> None:
        box = self.find(QCheckBox, name)
        if box.isChecked() is not on:
            QTest.mouseClick(box, LEFT, pos=QPoint(8, box.height() // 2))
        assert box.isChecked() is on

    def press(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        self.wait(button.isVisible)
        QTest.mouseClick(button, LEFT)

    @property
    def summary(self) -> str:
        return self.find(QLabel, "transcriptSummary").text()

    @property
    def faults(self) -> int:
        """How many the summary counts."""
        found = re.search(r"faults: ([\d,]+)", self.summary)
        assert found is not None
        return int(found[1].replace(",", ""))


@pytest.fixture
def reader(program: Program, simulator: SimulatedDevice, qtbot: QtBot) -> Reader:
    return Reader(program, simulator, qtbot)


def test_all_that_was_read_at_the_beginning_stands_there_in_words(reader: Reader) -> None:
    assert reader.view.model().rowCount() == 0
    reader.connect()
    reader.waits_for("get Serial Timeout → off (0)")
    assert "Opened" in reader.column(WORDS)[0]
    row = reader.row_of_the_signature()
    assert reader.column(RECEIVED)[row] == "54 52 65 58 31 2E 32"
    assert reader.column(WORDS)[row] == "get signature → TReX 1.2"
    assert not any("get currents" in text for text in reader.column(WORDS)), "polling is hidden"


def test_polling_is_shown_when_it_is_wanted(reader: Reader) -> None:
    reader.connect()
    reader.tick("transcriptPolling")
    reader.waits_for("get currents of both motors → motor 1: 0.00 A")
    assert "polling is hidden" not in reader.summary
    reader.tick("transcriptPolling", on=False)
    assert not any("get currents" in text for text in reader.column(WORDS))
    assert "polling is hidden" in reader.summary


def test_what_is_stored_and_what_is_refused_is_seen(reader: Reader) -> None:
    reader.connect()
    reader.device.parameters.edit("serial_timeout", 15)
    with reader.qtbot.waitSignal(reader.device.applied, timeout=15_000):
        reader.device.apply()
    reader.waits_for("set Serial Timeout to 1.5 s (15) → stored")


def test_answers_that_are_lost_are_faults_and_can_be_listed_alone(reader: Reader) -> None:
    reader.connect()
    reader.wait(lambda: "faults: " in reader.summary)
    before = reader.faults
    reader.simulator.do("line drop 4")
    reader.wait(lambda: reader.faults > before)
    reader.tick("transcriptFaults")
    reader.wait(lambda: reader.view.model().rowCount() > 0)
    for row in range(reader.view.model().rowCount()):
        said = reader.view.model().index(row, WORDS).data(Qt.ItemDataRole.AccessibleTextRole)
        assert str(said).startswith("Fault: ")


def test_words_and_bytes_are_searched(reader: Reader) -> None:
    reader.connect()
    reader.waits_for("get Serial Timeout")
    QTest.keyClick(reader.page, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    search = reader.find(QLineEdit, "transcriptSearch")
    QTest.keyClicks(search, "serial timeout")
    # Once, or again where an answer was late.
    reader.wait(lambda: len(set(reader.column(SENT))) == 1)
    search.setText("9f 07")
    reader.wait(lambda: set(reader.column(SENT)) == {"9F 07"})
    search.setText("no board says this")
    reader.wait(lambda: reader.view.model().rowCount() == 0)
    search.clear()
    reader.waits_for("get signature")


def test_what_is_held_still_stays_and_what_came_meanwhile_is_there_after(reader: Reader) -> None:
    reader.connect()
    reader.tick("transcriptPolling")
    reader.waits_for("get currents")
    reader.tick("transcriptPause")
    count, seen = reader.view.model().rowCount(), reader.device.transcript.everything.count
    reader.wait(lambda: reader.device.transcript.everything.count > seen + 50)
    assert reader.view.model().rowCount() == count
    assert "held still" in reader.summary
    reader.tick("transcriptFaults")
    reader.tick("transcriptFaults", on=False)
    assert reader.view.model().rowCount() == count, "nor does a search bring in what is newer"
    reader.tick("transcriptPause", on=False)
    reader.wait(lambda: reader.view.model().rowCount() > count + 50)


def test_the_chosen_row_is_shown_in_full_and_stays_chosen(reader: Reader) -> None:
    reader.connect()
    reader.waits_for("get Serial Timeout")
    row = reader.row_of_the_signature()
    reader.view.selectRow(row)
    details = reader.find(QPlainTextEdit, "transcriptDetails")
    assert "received  54 52 65 58 31 2E 32" in details.toPlainText()
    assert "at 19200 8N1" in details.toPlainText()
    assert "8 bytes need 4.2 ms on this wire" in details.toPlainText()
    details.selectAll()
    chosen = details.textCursor().selectedText()
    seen = reader.device.transcript.everything.count
    reader.wait(lambda: reader.device.transcript.everything.count > seen + 50)
    assert reader.view.currentIndex().row() == row
    assert details.textCursor().selectedText() == chosen, "to be copied"


def test_who_has_scrolled_up_is_left_there(reader: Reader) -> None:
    reader.connect()
    reader.tick("transcriptPolling")
    bar = reader.view.verticalScrollBar()
    reader.wait(lambda: bar.maximum() > 200)
    reader.wait(lambda: bar.value() == bar.maximum())
    bar.setValue(10)
    count = reader.view.model().rowCount()
    reader.wait(lambda: reader.view.model().rowCount() > count + 20)
    assert bar.value() == 10


def test_rows_are_copied_with_what_they_mean(reader: Reader) -> None:
    reader.connect()
    reader.waits_for("get signature")
    row = reader.row_of_the_signature()
    reader.view.selectRow(row)
    reader.view.setFocus()
    reader.press("transcriptCopyButton")
    text = QGuiApplication.clipboard().text()
    assert text.count("\n") == 1
    assert text.endswith("get signature → TReX 1.2\n")
    reader.view.clearSelection()
    reader.press("transcriptCopyButton")
    assert QGuiApplication.clipboard().text().count("\n") == len(reader.column(SENT))


def test_what_is_shown_is_saved(
    reader: Reader, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader.connect()
    reader.waits_for("get Serial Timeout")
    path = tmp_path / "line"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    with reader.qtbot.waitSignal(reader.page.told, timeout=15_000):
        reader.press("transcriptSaveButton")
    text = path.with_suffix(".txt").read_text(encoding="utf-8")
    assert "get Serial Timeout → off (0)" in text
    assert "get currents" not in text


def test_clear_forgets_and_goes_on(reader: Reader) -> None:
    reader.connect()
    reader.waits_for("get Serial Timeout")
    reader.press("transcriptClearButton")
    assert not any("get Serial Timeout" in text for text in reader.column(WORDS))
    reader.device.disconnect_line()
    reader.waits_for("Closed.")


def test_the_end_of_a_line_stands_there_and_the_rows_before_it_stay(reader: Reader) -> None:
    reader.connect()
    reader.waits_for("get Serial Timeout")
    reader.device.disconnect_line()
    reader.waits_for("Closed.")
    assert any("get Serial Timeout" in text for text in reader.column(WORDS))
    reader.connect()
    reader.wait(lambda: sum("Opened" in text for text in reader.column(WORDS)) == 2)
