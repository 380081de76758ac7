"""A person goes back to what a board was set to; the board is simulated by another process."""

from collections.abc import Callable
from typing import TypeVar

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QLabel,
    QPushButton,
    QTableView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.snapshots import take
from trex_gui.link.settings import LinkSettings
from trex_gui.model.comparison_table import ComparisonRole
from trex_gui.model.device import Link
from trex_gui.views.widgets.question import Question
from trex_gui.window import Program

WidgetT = TypeVar("WidgetT", bound=QWidget)


class Person:
    """What somebody sees and does in the window of the history."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program = program
        self.qtbot = qtbot
        self.dialog = self._in(program.window, QDialog, "historyDialog")

    def _in(self, parent: QWidget, kind: type[WidgetT], name: str) -> WidgetT:
        found = parent.findChild(kind, name)
        assert found is not None
        return found

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        return self._in(self.dialog, kind, name)

    def open(self) -> None:
        action = self.program.window.findChild(QAction, "historyAction")
        assert action is not None
        action.trigger()
        self.qtbot.waitUntil(self.dialog.isVisible)

    def change(self, **values: int) -> None:
        """Edit and apply, through the device: this is about what comes after."""
        for key, wire in values.items():
            self.program.device.parameters.edit(key, wire)
        self.apply()

    def apply(self) -> None:
        with self.qtbot.waitSignal(self.program.device.applied):
            self.program.device.apply()

    def choose(self, row: int) -> None:
        self.find(QTableView, "snapshotView").selectRow(row)
        self.qtbot.wait(1)

    @property
    def rows(self) -> QTableView:
        return self.find(QTableView, "comparisonTable")

    @property
    def compared(self) -> dict[str, tuple[str, str]]:
        model = self.rows.model()
        return {
            model.index(row, 0).data(ComparisonRole.KEY): (
                model.index(row, 1).data(),
                model.index(row, 2).data(),
            )
            for row in range(model.rowCount())
        }

    def tick_only(self, key: str) -> None:
        self.click("tickNoneButton")
        model = self.rows.model()
        row = list(self.compared).index(key)
        assert model.setData(
            model.index(row, 0), Qt.CheckState.Checked, Qt.ItemDataRole.CheckStateRole
        )

    def button(self, name: str) -> QPushButton:
        return self.find(QPushButton, name)

    def click(self, name: str) -> None:
        QTest.mouseClick(self.button(name), Qt.MouseButton.LeftButton)

    def text(self, name: str = "comparisonSummary") -> str:
        return self.find(QLabel, name).text()

    def until(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition)

    @property
    def review(self) -> QDialog:
        return self._in(self.program.window, QDialog, "reviewDialog")


@pytest.fixture
def person(program: Program, qtbot: QtBot, quick_simulator: SimulatedDevice) -> Person:
    program.device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    return Person(program, qtbot)


def pending(person: Person) -> dict[str, int]:
    return dict(person.program.device.parameters.pending)


def test_one_row_of_an_older_snapshot_comes_back(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.change(serial_timeout=5, motor1_acceleration=9)
    person.change(serial_timeout=7, motor2_acceleration=8)
    person.open()
    assert person.find(QTableView, "snapshotView").model().rowCount() == 2
    person.choose(1)
    person.until(lambda: len(person.compared) == 3)
    assert person.compared["serial_timeout"] == ("0.7 s", "off")
    person.tick_only("serial_timeout")
    with person.qtbot.waitSignal(person.dialog.restore_requested):  # type: ignore[attr-defined]
        person.click("restoreButton")
    assert pending(person) == {"serial_timeout": 0}
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 7
    assert person.review.isVisible()
    person.apply()
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0
    assert quick_simulator.show()["parameters"]["motor1_acceleration"] == 9
    person.review.close()
    person.until(lambda: person.find(QTableView, "snapshotView").model().rowCount() == 3)


def test_a_whole_snapshot_comes_back_as_one_step(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    before = quick_simulator.show()["parameters"]
    person.change(serial_timeout=5, motor1_acceleration=9)
    person.change(serial_timeout=7, motor2_acceleration=8)
    person.open()
    person.choose(1)
    person.until(lambda: len(person.compared) == 3)
    person.click("restoreButton")
    assert len(pending(person)) == 3
    person.until(lambda: "is set like this snapshot" in person.text())
    assert not person.button("restoreButton").isEnabled()
    person.program.device.undo.undo()
    assert not pending(person)
    person.until(lambda: person.button("restoreButton").isEnabled())
    person.click("restoreButton")
    person.apply()
    assert quick_simulator.show()["parameters"] == before
    person.review.close()


def test_edits_count_as_the_present(person: Person) -> None:
    person.change(serial_timeout=5)
    person.open()
    assert person.compared == {"serial_timeout": ("0.5 s", "off")}
    person.program.device.parameters.edit("serial_timeout", 9)
    person.until(lambda: person.compared == {"serial_timeout": ("0.9 s", "off")})
    person.program.device.parameters.edit("serial_timeout", 0)
    person.until(lambda: not person.compared)


def test_a_row_that_was_unticked_stays_so_while_edits_are_made(person: Person) -> None:
    person.change(serial_timeout=5, motor1_acceleration=9)
    person.open()
    person.tick_only("serial_timeout")
    person.program.device.parameters.edit("motor2_acceleration", 4)
    person.until(lambda: len(person.compared) == 3)
    person.click("restoreButton")
    assert pending(person) == {"serial_timeout": 0, "motor2_acceleration": 4}
    person.review.close()


def test_a_snapshot_of_another_model_cannot_be_restored(person: Person) -> None:
    take(person.program.device.history, model="trexjr")
    person.open()
    assert not person.button("restoreButton").isEnabled()
    assert "of a TReX Jr, and the board here is a TReX" in person.text("restoreNote")


def test_another_board_of_the_same_model_is_pointed_out(person: Person) -> None:
    take(person.program.device.history, device_number=9)
    person.open()
    assert person.button("restoreButton").isEnabled()
    assert "device number 9, the board here is number 7" in person.text("restoreNote")


def test_the_plug_is_pulled_and_put_back_while_it_is_open(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.change(serial_timeout=5)
    person.change(serial_timeout=7)
    person.open()
    box = person.find(QComboBox, "compareWithCombo")
    assert box.currentText().startswith("the board")
    quick_simulator.do("line unplug")
    person.until(lambda: not person.button("restoreButton").isEnabled())
    person.until(lambda: person.program.device.link is not Link.UP)
    person.program.connector.disconnect_port()
    person.until(lambda: "No board is connected" in person.text("restoreNote"))
    person.until(lambda: box.currentText().startswith("snapshot of"))
    person.until(lambda: person.compared == {"serial_timeout": ("off", "0.5 s")})
    quick_simulator.do("line plug")
    person.program.device.connect_to(LinkSettings(quick_simulator.url))
    person.until(lambda: person.program.device.link is Link.UP)
    person.until(lambda: person.button("restoreButton").isEnabled())
    person.until(lambda: person.compared == {"serial_timeout": ("0.7 s", "0.5 s")})


def test_a_board_that_falls_silent_takes_nothing(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.change(serial_timeout=5)
    person.open()
    quick_simulator.do("line mute on")
    person.until(lambda: person.program.device.link is Link.SILENT)
    person.until(lambda: "does not answer" in person.text("restoreNote"))
    assert not person.button("restoreButton").isEnabled()
    assert person.compared == {"serial_timeout": ("0.5 s", "off")}


def test_the_stop_button_stays_in_reach(person: Person) -> None:
    take(person.program.device.history)
    person.open()
    person.click("deleteSnapshotButton")
    assert person.find(Question, "historyQuestion").isVisible()
    assert person.dialog.windowModality() is Qt.WindowModality.NonModal
    stop = person.program.window.findChild(QPushButton, "stopButton")
    assert stop is not None
    with person.qtbot.waitSignal(person.program.device.motors.stop_requested):
        QTest.mouseClick(stop, Qt.MouseButton.LeftButton)


def test_it_closes_with_the_window(person: Person) -> None:
    person.open()
    person.program.window.close()
    assert not person.dialog.isVisible()


def test_without_a_board_it_can_be_looked_at(program: Program, qtbot: QtBot) -> None:
    take(program.device.history)
    person = Person(program, qtbot)
    person.open()
    assert "No board is connected" in person.text("restoreNote")
