"""On a low screen, and whatever is asked, the red button is in sight and does what it says."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QAction, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QFileDialog,
    QScrollArea,
    QSlider,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.held_line import before_storing
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.runtime import runtime
from trex_gui.views.widgets.question import Question
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

LOW = (960, 500)


class Desk:
    """The window with a simulated board."""

    def __init__(self, program: Program, simulator: VirtualSimulator, qtbot: QtBot) -> None:
        self.program, self.device = program, program.device
        self.window, self.simulator, self.qtbot = program.window, simulator, qtbot
        self.goes_on = False
        self.device.connect_to(LinkSettings(simulator.url))
        self.wait(lambda: self.device.link is Link.UP)

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=20_000)

    def button(self, name: str) -> QAbstractButton:
        found = self.window.findChild(QAbstractButton, name)
        assert found is not None, name
        return found

    def press(self, name: str) -> None:
        QTest.mouseClick(self.button(name), Qt.MouseButton.LeftButton)

    def choose(self, name: str) -> None:
        action = self.window.findChild(QAction, f"{name}Action")
        assert action is not None
        assert action.isEnabled()
        action.trigger()

    @property
    def question(self) -> Question:
        found = self.window.findChild(Question, "question")
        assert found is not None
        return found

    def stop_is_in_sight(self) -> bool:
        stop = self.button("stopButton")
        place = QRect(stop.mapTo(self.window, QPoint(0, 0)), stop.size())
        return stop.isVisible() and self.window.rect().contains(place)

    def stop_works(self) -> bool:
        with self.qtbot.waitSignal(self.device.motors.stop_requested):
            self.press("stopButton")
        return True

    def begin_to_write(self) -> int:
        """Begin to write a dozen settings."""
        keys = [key for key in self.device.parameters.all_stored if key.startswith("motor")][:12]
        for key in keys:
            stored = self.device.parameters.all_stored[key]
            self.device.parameters.edit(key, 1 - min(1, stored))
        count = self.device.pending
        self.device.apply()
        assert self.device.applying
        return count


@pytest.fixture
def desk(program: Program, quick_simulator: VirtualSimulator, qtbot: QtBot) -> Desk:
    return Desk(program, quick_simulator, qtbot)


@pytest.fixture
def slow(desk: Desk) -> Iterator[Desk]:
    """A line that stores the third setting only when it `goes_on`, so that it can be cut off."""

    def wait() -> None:
        while not desk.goes_on:
            runtime().sleep(0.01)

    before_storing(desk.simulator, 3, wait)
    yield desk
    desk.goes_on = True


# --- Low screens ------------------------------------------------------------------------


@pytest.mark.parametrize("page", range(6))
def test_the_stop_button_is_in_sight_on_a_low_screen(desk: Desk, page: int) -> None:
    desk.window.pages.setCurrentIndex(page)
    desk.device.parameters.edit("serial_timeout", 15)
    desk.window.resize(*LOW)
    assert desk.window.minimumSizeHint().height() <= 480
    assert desk.window.height() == LOW[1]
    assert desk.stop_is_in_sight()


def test_a_message_and_a_question_leave_room_for_the_stop_button(desk: Desk) -> None:
    desk.window.resize(*LOW)
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.failed.emit("Something went wrong, and it takes a while to say what. " * 6)
    desk.choose("reload")
    assert desk.window.minimumSizeHint().height() <= 480
    assert desk.window.height() == LOW[1]
    assert desk.stop_is_in_sight()


def test_what_does_not_fit_scrolls(desk: Desk) -> None:
    desk.window.resize(*LOW)
    desk.choose("page3")
    area = desk.window.findChild(QScrollArea, "motorsPageArea")
    assert area is not None
    assert area.verticalScrollBar().maximum() > 0
    desk.window.resize(960, 800)
    assert area.verticalScrollBar().maximum() == 0


def test_the_parameters_keep_rows_in_sight_on_a_low_screen(desk: Desk) -> None:
    desk.window.resize(*LOW)
    desk.choose("page5")
    view = desk.window.findChild(QWidget, "parametersView")
    area = desk.window.findChild(QScrollArea, "parametersPageArea")
    assert view is not None
    assert area is not None
    assert view.height() > 100
    assert area.verticalScrollBar().maximum() == 0


def test_the_wheel_scrolls_the_page_and_drives_no_motor(desk: Desk) -> None:
    desk.window.resize(*LOW)
    desk.choose("page3")
    desk.press("runButton")
    area = desk.window.findChild(QScrollArea, "motorsPageArea")
    slider = desk.window.findChild(QSlider, "motor1Slider")
    assert area is not None
    assert slider is not None
    desk.wait(slider.isEnabled)
    slider.setFocus()
    place = QPointF(slider.rect().center())
    turn = QWheelEvent(
        place,
        QPointF(slider.mapToGlobal(place.toPoint())),
        QPoint(),
        QPoint(0, -120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(slider, turn)
    assert slider.value() == 0
    assert not turn.isAccepted() or area.verticalScrollBar().value() > 0


# --- Reload -----------------------------------------------------------------------------


def test_reloading_asks_in_the_window_and_the_stop_button_works(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.choose("reload")
    assert "forget the edits" in desk.question.text
    assert not desk.question.isWindow()
    assert desk.stop_works()
    desk.press("questionCancel")
    assert not desk.question.isVisible()
    assert desk.device.pending == 1
    desk.choose("reload")
    desk.press("reloadYes")
    assert desk.device.pending == 0


def test_a_question_goes_when_its_edits_are_gone(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.choose("reload")
    desk.choose("discard")
    assert not desk.question.isVisible()


# --- While settings are being written ---------------------------------------------------


@pytest.mark.parametrize("how", ["button", "menu", "list"])
def test_disconnecting_while_settings_are_written_asks_first(slow: Desk, how: str) -> None:
    count = slow.begin_to_write()
    if how == "button":
        slow.press("connectButton")
    elif how == "menu":
        slow.choose("disconnect")
    else:
        combo = slow.window.findChild(QComboBox, "portCombo")
        assert combo is not None
        combo.activated.emit(0)
    assert "Settings are being written. Disconnect all the same?" in slow.question.text
    assert slow.device.link is Link.UP
    slow.press("disconnectYes")
    slow.goes_on = True
    slow.wait(lambda: slow.device.link is Link.NONE)
    assert 0 < slow.device.pending <= count


def test_a_disconnect_that_was_taken_back_lets_writing_end(slow: Desk) -> None:
    slow.begin_to_write()
    slow.press("connectButton")
    slow.press("questionCancel")
    slow.goes_on = True
    slow.wait(lambda: not slow.device.applying)
    assert slow.device.pending == 0
    assert slow.device.link is Link.UP


def test_the_question_goes_when_everything_is_written(slow: Desk) -> None:
    slow.begin_to_write()
    slow.press("connectButton")
    slow.goes_on = True
    slow.wait(lambda: not slow.device.applying)
    slow.wait(lambda: not slow.question.isVisible())
    assert slow.device.link is Link.UP


def test_closing_while_settings_are_written_asks_first(slow: Desk) -> None:
    slow.begin_to_write()
    assert not slow.window.close()
    assert "Settings are being written. Close all the same?" in slow.question.text
    assert slow.window.isVisible()
    slow.goes_on = True  # closing waits for what is being stored
    slow.press("closeYes")
    assert not slow.window.isVisible()


# --- Closing with edits -----------------------------------------------------------------


def test_closing_with_edits_asks_in_the_window_and_the_stop_button_works(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    assert not desk.window.close()
    assert "not applied" in desk.question.text
    assert desk.stop_works()
    desk.press("questionCancel")
    assert desk.window.isVisible()
    assert desk.device.link is Link.UP
    assert not desk.window.close()
    desk.press("closeYes")
    assert not desk.window.isVisible()


def test_closing_with_edits_offers_to_save_them(
    desk: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "kept.txt"
    desk.device.parameters.edit("serial_timeout", 15)
    desk.window.close()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: ("", ""))
    desk.press("saveAndClose")
    assert desk.window.isVisible()
    desk.window.close()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    desk.press("saveAndClose")
    assert not desk.window.isVisible()
    assert "1.5 s" in path.read_text(encoding="utf-8")


def test_a_file_that_cannot_be_saved_keeps_the_window(
    desk: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "no such folder" / "kept.txt"
    desk.device.parameters.edit("serial_timeout", 15)
    desk.window.close()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    desk.press("saveAndClose")
    assert desk.window.isVisible()
