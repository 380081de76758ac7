"""Transcript page, which lists the traffic on the line."""

import re
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QFileDialog, QLabel, QLineEdit, QPlainTextEdit

from tests.end_to_end.test_boards_on_one_line import connect
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.ui.theme.theme import select_font_size
from trex_gui.ui.traffic.page import TrafficPage
from trex_gui.ui.traffic.table import MEANING, RECEIVED, SENT, TrafficView
from trex_gui.ui.widgets.labels import ElidedLabel, PageHead


class TrafficDriver(WidgetDriver):
    """Driver of the Transcript page. The constructor opens the page."""

    def __init__(self, window: WindowDriver) -> None:
        super().__init__(window.open_page("transcriptPage").root, window.qtbot)
        self._window = window
        self.view = self.find(TrafficView, "transcriptView")
        self._traffic = window.device.connection.traffic

    def column(self, column: int) -> list[str]:
        """Return the texts of a column from the top."""
        model = self.view.model()
        return [str(model.index(row, column).data()) for row in range(self.rows)]

    @property
    def rows(self) -> int:
        return self.view.model().rowCount()

    def shows(self, text: str) -> bool:
        """Return whether a row shows a text."""
        return any(text in meaning for meaning in self.column(MEANING))

    def wait_for_row(self, text: str) -> None:
        self.wait(lambda: self.shows(text))

    def row_of_signature(self) -> int:
        """Return the last row that requests the signature."""
        return max(row for row, sent in enumerate(self.column(SENT)) if sent == "81")

    def check(self, name: str, checked: bool = True) -> None:
        if self.find(QCheckBox, name).isChecked() is not checked:
            self.click(name)
        assert self.find(QCheckBox, name).isChecked() is checked

    def wait_for_traffic(self) -> None:
        """Wait for 50 more transactions."""
        before = self._traffic.everything.count
        self.wait(lambda: self._traffic.everything.count > before + 50)

    @property
    def summary(self) -> str:
        """Return the state in the page head."""
        return self._window.find(PageHead, "diagnosticsHead").findChildren(ElidedLabel)[-1].text()

    @property
    def faults(self) -> int:
        """Return the number of faults in the summary."""
        found = re.search(r"(\d+) faults?", self.summary)
        return int(found[1]) if found else 0


@pytest.fixture
def page(window: WindowDriver) -> TrafficDriver:
    return TrafficDriver(window)


def test_traffic_is_listed_from_connect_to_disconnect(
    window: WindowDriver, page: TrafficDriver, simulator: SimulatedDevice
) -> None:
    assert page.rows == 0
    window.connect(simulator.url)
    page.wait_for_row("get Device Number → 7")
    assert "Opened" in page.column(MEANING)[0]
    row = page.row_of_signature()
    assert page.column(RECEIVED)[row] == "54 52 65 58 31 2E 32"
    assert page.column(MEANING)[row] == "get signature → TReX 1.2"
    assert not page.shows("get currents"), "polling is hidden"

    window.apply(serial_timeout=15)
    page.wait_for_row("set Serial Timeout to 1.5 s (15) → stored")

    window.disconnect()
    page.wait_for_row("Closed.")
    assert page.shows("get Device Number")
    window.connect(simulator.url)
    page.wait(lambda: sum("Opened" in text for text in page.column(MEANING)) == 2)
    page.click("transcriptClearButton")
    assert not page.shows("get Device Number")
    assert not page.shows("Closed.")
    window.disconnect()
    page.wait_for_row("Closed.")


def test_traffic_is_searched_and_filtered_by_faults(
    window: WindowDriver, page: TrafficDriver, simulator: SimulatedDevice
) -> None:
    window.connect(simulator.url)
    page.wait_for_row("get Device Number")
    QTest.keyClick(page.root, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    search = window.find(QLineEdit, "diagnosticsSearch")
    QTest.keyClicks(search, "device number")
    page.wait(lambda: set(page.column(SENT)) <= {"9F 00", "80 07 1F 00"})
    search.setText("9f 00")
    page.wait(lambda: set(page.column(SENT)) == {"9F 00"})
    search.setText("no board says this")
    page.wait(lambda: page.rows == 0)
    search.clear()
    page.wait_for_row("get signature")

    page.wait(lambda: "fault" in page.summary)
    before = page.faults
    simulator.do("line drop 4")
    page.wait(lambda: page.faults > before)
    page.check("transcriptFaults")
    page.wait(lambda: page.rows > 0)
    for row in range(page.rows):
        index = page.view.model().index(row, MEANING)
        assert str(index.data(Qt.ItemDataRole.AccessibleTextRole)).startswith("Fault: ")


def test_polling_is_shown_on_request_and_log_can_be_paused(
    window: WindowDriver, page: TrafficDriver, simulator: SimulatedDevice
) -> None:
    window.connect(simulator.url)
    page.check("transcriptPolling")
    page.wait_for_row("get currents of both motors → motor 1: 0.00 A")
    assert "polling hidden" not in page.summary

    bar = page.view.verticalScrollBar()
    page.wait(lambda: bar.maximum() > 200)
    page.wait(lambda: bar.value() == bar.maximum())
    bar.setValue(10)
    count = page.rows
    page.wait(lambda: page.rows > count + 20)
    assert bar.value() == 10, "new rows do not scroll"

    page.check("transcriptPause")
    count = page.rows
    page.wait_for_traffic()
    assert page.rows == count
    assert "paused" in page.summary
    page.check("transcriptFaults")
    page.check("transcriptFaults", checked=False)
    assert page.rows == count, "a new search adds no newer rows"
    page.check("transcriptPause", checked=False)
    page.wait(lambda: page.rows > count + 50)

    page.check("transcriptPolling", checked=False)
    assert not page.shows("get currents")
    assert "polling hidden" in page.summary

    select_font_size(150)
    window.window.resize(1100, 700)  # wide enough for the meanings beside the bytes
    readable = 40 * page.view.fontMetrics().averageCharWidth()
    page.wait(lambda: page.view.columnWidth(MEANING) >= readable)


def test_rows_are_shown_in_detail_copied_and_saved(
    window: WindowDriver,
    page: TrafficDriver,
    simulator: SimulatedDevice,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    window.connect(simulator.url)
    page.wait_for_row("get Device Number")
    row = page.row_of_signature()
    page.view.selectRow(row)
    details = page.find(QPlainTextEdit, "transcriptDetails")
    assert "received  54 52 65 58 31 2E 32" in details.toPlainText()
    assert "at 19200 baud" in details.toPlainText()
    assert "8 bytes take 4.2 ms at this baud rate" in details.toPlainText()
    details.selectAll()
    selected = details.textCursor().selectedText()
    page.wait_for_traffic()
    assert page.view.currentIndex().row() == row
    assert details.textCursor().selectedText() == selected, "the selection remains"

    page.view.setFocus()
    window.click("diagnosticsCopy")
    text = QGuiApplication.clipboard().text()
    assert text.count("\n") == 1
    assert text.endswith("get signature → TReX 1.2\n")
    page.view.clearSelection()
    window.click("diagnosticsCopy")
    assert QGuiApplication.clipboard().text().count("\n") == page.rows
    page.view.selectRow(row)
    page.view.setFocus()
    for key, text in (
        ("P", 'write(bytes.fromhex("81"))'),
        ("A", "{0x81};"),
    ):
        modifiers = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
        QTest.keyClick(page.view, getattr(Qt.Key, f"Key_{key}"), modifiers)
        assert text in QGuiApplication.clipboard().text()
    page.view.clearSelection()

    path = tmp_path / "line"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    assert isinstance(page.root, TrafficPage)
    with window.qtbot.waitSignal(window.device.notifier.info):
        page.find(QAction, "transcriptSaveAction").trigger()
    text = path.with_suffix(".txt").read_text(encoding="utf-8")
    assert "get Device Number → 7" in text
    assert "get currents" not in text


def test_typed_bytes_are_explained_and_sent(
    window: WindowDriver, page: TrafficDriver, simulator: SimulatedDevice
) -> None:
    def meaning() -> str:
        return page.text("transcriptMeaning")

    page.type_into("transcriptBytes", "9F 0", enter=False)
    assert "“9F 0” is not a sequence of hexadecimal bytes" in meaning()
    page.type_into("transcriptBytes", "9F 07", enter=False)
    assert meaning() == "get Serial Timeout\nConnect to a board first."
    window.connect(simulator.url)
    page.wait(lambda: page.view.verticalScrollBar().maximum() > 100 and page.view.is_at_bottom)
    window.window.resize(1100, 640)
    assert page.view.is_at_bottom, "a low window still scrolls to new rows"
    assert meaning() == "get Serial Timeout"
    with window.qtbot.waitSignal(window.device.notifier.info) as info:
        page.type_into("transcriptBytes", "9F 07")
    assert info.args == ["Sent 9F 07; the reply is 00."]
    page.wait(lambda: page.column(SENT)[-1] == "9F 07")  # a poll, which is normally hidden

    page.type_into("transcriptBytes", "AF 07 05 55 2A", enter=False)
    assert "set Serial Timeout to 0.5 s (5) (stored at once" in meaning()
    page.click("transcriptSendButton")
    page.wait(lambda: window.device.parameters.values.stored.get("serial_timeout") == 5)

    page.type_into("transcriptBytes", "81 9F 07 9F 08 82 C2 50", enter=False)
    assert "set motor 1 to forward 80 (may move a motor)\nand 2 more packets" in meaning()
    assert "get mode" not in meaning()
    assert "get mode" in page.find(QLabel, "transcriptMeaning").toolTip()
    page.type_into("transcriptBytes", "C2 50")
    assert meaning().endswith("(may move a motor)\nArm the motors first.")
    assert not page.is_enabled("transcriptSendButton")
    window.trigger("run")
    page.wait(lambda: page.is_enabled("transcriptSendButton"))
    page.click("transcriptSendButton")
    page.wait(lambda: simulator.show()["motors"][0]["speed"] == 80)
    assert window.device.may_move
    window.press_escape()
    page.wait(lambda: simulator.show()["motors"][0]["direction"] == "brake")
    page.wait(lambda: not window.device.may_move)
    assert "Sent by hand: set motor 1 to forward 80" in {
        event.text for event in window.device.events.all
    }

    page.type_into("transcriptBytes", "AF 07 05 55 2A", enter=False)
    assert page.is_enabled("transcriptSendButton")
    window.device.driving.set_reaching_several(True)
    assert page.text("transcriptMeaning").endswith("store the value: select a board.")
    assert not page.is_enabled("transcriptSendButton")


def test_typed_write_to_every_board_on_a_line_is_not_sent(
    window: WindowDriver, page: TrafficDriver, start_simulator: StartSimulator
) -> None:
    boards = start_simulator("--unpaced", "--device", "7", "--device", "9")
    connect(window, boards.url, 7)

    def numbers() -> list[int]:
        return [boards.show(f"@{number}")["parameters"]["device_number"] for number in (7, 9)]

    page.type_into("transcriptBytes", "AF 00 0C 55 2A")
    expected = "board on this line would store the value: address device 7."
    assert page.text("transcriptMeaning").endswith(expected)
    assert not page.is_enabled("transcriptSendButton")
    assert numbers() == [7, 9]
    page.type_into("transcriptBytes", "80 07 2F 00 0C 55 2A")
    window.wait(lambda: numbers() == [12, 9])
