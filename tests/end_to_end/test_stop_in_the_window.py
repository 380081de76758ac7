"""Everything in the window that stops the motors, against a simulated board in its own process."""

import sys
from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QLabel,
    QMessageBox,
    QPushButton,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.end_to_end.test_every_stop_cause import is_stopped
from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

MOTORS_PAGE = 3


class Desk:
    """A window that drives a board."""

    def __init__(self, program: Program, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        self.program, self.qtbot, self.simulator = program, qtbot, simulator
        self.motors = program.device.motors
        program.device.connect_to(LinkSettings(simulator.url))
        qtbot.waitUntil(lambda: program.device.link is Link.UP and self.motors.can_arm)
        self.arm()

    def arm(self) -> None:
        self.program.window.pages.setCurrentIndex(MOTORS_PAGE)
        self.motors.arm()
        self.motors.accelerate = False
        assert self.motors.armed
        self.motors.set_speed(1, 60)
        self.motors.set_auxiliary(50)
        self.qtbot.waitUntil(self.drives)

    def drives(self) -> bool:
        shown = self.simulator.show()
        return (shown["motors"][0]["speed"], shown["aux"]["speed"]) == (60, 50)

    def button(self, name: str) -> QPushButton:
        found = self.program.window.findChild(QPushButton, name)
        assert found is not None, name
        return found

    def text(self, name: str) -> str:
        found = self.program.window.findChild(QLabel, name)
        assert found is not None, name
        return found.text()

    def slider(self) -> QSlider:
        found = self.program.window.findChild(QSlider, "motor1Slider")
        assert found is not None
        return found

    def expect_stop(self) -> None:
        self.qtbot.waitUntil(lambda: is_stopped(self.simulator))
        assert not self.motors.armed
        assert self.motors.drive(1) is None
        assert self.slider().value() == 0


@pytest.fixture
def desk(program: Program, qtbot: QtBot, simulator: SimulatedDevice) -> Desk:
    return Desk(program, qtbot, simulator)


def press_escape() -> None:
    """Press Esc wherever the keyboard is, as the system brings it."""
    window = QApplication.focusWindow()
    assert window is not None
    QTest.keyClick(window, Qt.Key.Key_Escape)


# --- What stops -------------------------------------------------------------------------


@pytest.mark.parametrize("page", range(6))
def test_the_red_button_stops_on_every_page(desk: Desk, page: int) -> None:
    stop = desk.button("stopButton")
    if page != MOTORS_PAGE:
        desk.program.window.pages.setCurrentIndex(page)
    assert desk.motors.armed
    assert not is_stopped(desk.simulator)
    assert stop.isVisible()
    QTest.mousePress(stop, Qt.MouseButton.LeftButton)  # when it is pressed, not when it is let go
    desk.expect_stop()
    QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)


def test_the_red_button_obeys_the_keyboard(desk: Desk) -> None:
    stop = desk.button("stopButton")
    stop.setFocus()
    QTest.keyClick(stop, Qt.Key.Key_Space)
    desk.expect_stop()


def test_escape_stops(desk: Desk) -> None:
    press_escape()
    desk.expect_stop()


def test_the_menu_stops(desk: Desk) -> None:
    action = desk.program.window.findChild(QAction, "stopAction")
    assert action is not None
    action.trigger()
    desk.expect_stop()


def test_escape_stops_in_a_modal_dialog(desk: Desk) -> None:
    box = QMessageBox(desk.program.window)
    box.setText("Anything")
    seen: list[bool] = []

    def press() -> None:
        press_escape()
        seen.append(desk.motors.armed)

    QTimer.singleShot(100, press)
    box.exec()
    assert seen == [False]
    desk.expect_stop()


def handle_of(slider: QSlider) -> QPoint:
    """Where the handle of a slider is."""
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    return (
        slider.style()
        .subControlRect(
            QStyle.ComplexControl.CC_Slider, option, QStyle.SubControl.SC_SliderHandle, slider
        )
        .center()
    )


def test_escape_stops_while_a_slider_is_dragged_and_dragging_on_drives_nothing(desk: Desk) -> None:
    slider = desk.slider()
    start = handle_of(slider)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(slider, start + QPoint(20, 0))
    assert desk.motors.armed
    press_escape()
    for step in range(20):
        QTest.mouseMove(slider, start + QPoint(20 + step, 0))
    desk.qtbot.waitUntil(lambda: is_stopped(desk.simulator))
    desk.qtbot.wait(200)
    assert is_stopped(desk.simulator), "a drag that goes on comes too late"
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton)
    assert is_stopped(desk.simulator)


def test_a_held_control_that_is_lost_stops(desk: Desk) -> None:
    desk.motors.hold("drive pad")
    desk.motors.set_speed(1, 90, "drive pad")
    desk.motors.lose("drive pad", "The Motors page was left.")
    desk.expect_stop()
    desk.qtbot.waitUntil(lambda: "The Motors page was left." in desk.text("motorStateLabel"))


@pytest.mark.parametrize(
    "leave",
    [
        lambda desk: desk.program.device.disconnect_line(),
        lambda desk: desk.program.window.close(),
    ],
    ids=["disconnect", "close"],
)
def test_leaving_stops(desk: Desk, leave: Callable[[Desk], object]) -> None:
    leave(desk)
    desk.qtbot.waitUntil(lambda: is_stopped(desk.simulator))


def test_a_stop_that_is_pressed_while_the_board_is_still_read_is_sent(
    program: Program, qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    program.device.connect_to(LinkSettings(simulator.url))
    assert program.device.link is Link.OPENING
    stop = program.window.findChild(QPushButton, "stopButton")
    assert stop is not None
    assert stop.isEnabled()
    QTest.mousePress(stop, Qt.MouseButton.LeftButton)
    QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: simulator.show()["counters"]["packets"] > 2)
    qtbot.waitUntil(lambda: is_stopped(simulator))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)


# --- The lock, and what is said ---------------------------------------------------------


def test_after_a_stop_nothing_can_be_armed_for_a_while_and_the_bar_counts_down(
    desk: Desk,
) -> None:
    desk.motors.lockout = 6.0
    run = desk.button("runButton")
    QTest.mouseClick(desk.button("stopButton"), Qt.MouseButton.LeftButton)
    assert not run.isEnabled()
    desk.motors.arm()
    assert not desk.motors.armed
    desk.qtbot.waitUntil(lambda: "Motors are locked for" in desk.text("motorStateLabel"))
    desk.expect_stop()
    desk.qtbot.waitUntil(run.isEnabled)
    desk.arm()


def test_the_window_says_that_the_boards_own_timeout_is_off_and_sets_it_with_a_click(
    desk: Desk,
) -> None:
    device = desk.program.device
    desk.motors.stop()
    desk.expect_stop()
    notice = desk.program.window.findChild(QWidget, "timeoutNotice")
    assert notice is not None
    assert notice.isVisible()
    assert device.serial_timeout_s == 0
    device.parameters.edit("motor1_acceleration", 9)
    pending = device.pending
    button = desk.button("timeoutButton")
    assert button.accessibleName()
    with desk.qtbot.waitSignal(device.applied):
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert desk.simulator.show()["parameters"]["serial_timeout"] == 5
    assert device.serial_timeout_s == pytest.approx(0.5)
    assert not notice.isVisible()
    assert device.pending == pending == 1, "other edits go on waiting"
    assert len(device.history.snapshots()) == 1


def test_a_stop_that_channels_drive_through_is_not_called_one(
    program: Program, qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    for line in ("jumper mode rc", "power cycle"):
        quick_simulator.do(line)
    device = program.device
    device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.link is Link.UP)
    qtbot.waitUntil(lambda: not quick_simulator.show()["safe_start"])  # it has seen it at rest
    quick_simulator.do("channel 1 1900us")
    qtbot.waitUntil(lambda: quick_simulator.show()["motors"][0]["speed"] > 50)
    press_escape()
    banner = program.window.findChild(QLabel, "bannerText")
    state = program.window.findChild(QLabel, "motorStateLabel")
    assert banner is not None
    assert state is not None
    qtbot.waitUntil(lambda: "Let go of the sticks, or cut the power." in banner.text())
    assert quick_simulator.show()["motors"][0]["speed"] > 50
    qtbot.waitUntil(lambda: "Stop does not reach what they drive" in state.text())
    assert "Stopped" not in state.text()
