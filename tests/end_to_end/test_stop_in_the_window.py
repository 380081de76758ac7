"""Controls and keys of the windows that stop the motors."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QMenu, QMessageBox, QPushButton, QWidget

from tests.support.pages.every_window import WINDOWS_WITH_STOP, stop_button
from tests.support.pages.motors import BRAKE, Gesture, MotorsPage, is_stopped
from tests.support.pages.parameters import ParametersPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WindowDriver
from trex_gui.ui.devices.connection import ConnectionState


class DrivingWindow(MotorsPage):
    """Motors page of a board that drives all motors. The line has a realistic baud rate."""

    def __init__(self, window: WindowDriver, simulator: SimulatedDevice) -> None:
        window.connect(simulator.url)
        super().__init__(window, simulator)
        self.motors.lockout = 0
        self.motors.accelerate = False
        self.drive()

    def drive(self) -> None:
        self.show_page()
        self.wait(lambda: self.motors.is_available and not self.motors.locked_for)
        self.motors.arm()
        assert self.is_armed()
        self.motors.set_speed(1, 60)
        self.motors.set_auxiliary(50)
        self.wait(self.is_driving)

    def is_driving(self) -> bool:
        shown = self.simulator.show()
        return (shown["motors"][0]["speed"], shown["aux"]["speed"]) == (60, 50)

    def repeat_escape(self) -> None:
        """Simulate the key repeat of a held Esc."""
        self.activate()
        window, none = self.window.windowHandle(), Qt.KeyboardModifier.NoModifier
        QTest.simulateEvent(window, True, Qt.Key.Key_Escape, none, "", True)

    def expect_stop(self, cause: str) -> None:
        """Check that the motors are disarmed at once. Wait until the board has stopped."""
        assert not self.is_armed(), cause
        self.wait(lambda: is_stopped(self.simulator))
        assert self.motors.drive(1) is None, cause
        assert self.slider_value("motor1Slider") == 0, cause


@pytest.fixture
def driving(window: WindowDriver, simulator: SimulatedDevice) -> DrivingWindow:
    return DrivingWindow(window, simulator)


# --- Stop controls -------------------------------------------------------------------------


def test_stop_button_stops_on_press_on_every_page(driving: DrivingWindow) -> None:
    stop = driving.button("stopButton")
    for area in driving.each_page():
        page = area.objectName()
        assert driving.is_armed(), page
        assert driving.is_driving(), page
        assert stop.isVisible(), page
        QTest.mousePress(stop, LEFT)
        driving.expect_stop(page)
        QTest.mouseRelease(stop, LEFT)
        driving.drive()


def test_motors_stop_at_every_stop_control(driving: DrivingWindow) -> None:
    stop = driving.button("stopButton")
    stop.setFocus()
    QTest.keyClick(stop, Qt.Key.Key_Space)
    driving.expect_stop("space on the red button")
    driving.drive()
    driving.press_escape()
    driving.expect_stop("Esc")
    driving.drive()
    driving.trigger("stop")
    driving.expect_stop("menu")

    driving.drive()
    box = QMessageBox(driving.window)
    box.setText("Anything")
    box.setWindowModality(Qt.WindowModality.ApplicationModal)
    box.show()
    driving.wait(box.isActiveWindow)
    driving.press_escape()
    driving.expect_stop("Esc in a modal dialog")
    box.close()

    driving.drive()
    driving.motors.acquire("drive pad")
    driving.motors.set_speed(1, 90, "drive pad")
    driving.motors.abort("drive pad", "The Motors page was left.")
    driving.expect_stop("lost control")
    driving.wait_for_text("motorStateLabel", "The Motors page was left.")


@pytest.mark.qt_log_ignore("does not support", extend=True)  # popups offscreen
def test_escape_closes_popup_and_stops_motors_that_may_move(driving: DrivingWindow) -> None:
    menu = driving.window.menuBar().actions()[0].menu()
    assert isinstance(menu, QMenu)
    combo = QComboBox(driving.window)
    combo.addItems(["1", "2"])
    combo.show()
    page = ParametersPage(driving)
    value = page.index_of("serial_timeout")

    def is_edited() -> bool:
        return page.view.indexWidget(value) is not None

    popups: dict[str, tuple[Gesture, Callable[[], bool]]] = {
        "menu": (lambda: menu.popup(QPoint(9, 9)), menu.isVisible),
        "list": (combo.showPopup, combo.view().isVisible),
        "editor": (lambda: page.view.edit(value), is_edited),
    }

    for name, (open_popup, is_open) in popups.items():
        open_popup()
        driving.wait(is_open)
        driving.press_escape()
        driving.expect_stop(name)
        driving.wait(lambda: not is_open())  # noqa: B023 - called at once
        driving.drive()
        driving.open_page("parametersPage")

    driving.motors.stop()
    driving.wait(lambda: not driving.program.device_manager.needs_stop)
    stops: list[str] = []
    driving.motors.stop_requested.connect(lambda: stops.append("stop"))
    for name, (open_popup, is_open) in popups.items():
        open_popup()
        driving.wait(is_open)
        driving.press_escape()
        driving.wait(lambda: not is_open())  # noqa: B023 - called at once
        for _ in range(3):
            driving.repeat_escape()
        assert not stops, f"{name}: a held key has no further effect"
    driving.press_escape()
    driving.repeat_escape()
    assert stops == ["stop"]


def test_escape_closes_dialog_and_stops_motors_that_may_move(driving: DrivingWindow) -> None:
    stops: list[str] = []
    driving.motors.stop_requested.connect(lambda: stops.append("stop"))

    def press_escape_in(entry: str, name: str) -> bool:
        """Return whether the dialog is still open."""
        driving.trigger(entry)
        dialog = driving.help if name == "helpDialog" else driving.dialog(name).root
        dialog.activateWindow()
        driving.wait(dialog.isActiveWindow)
        QTest.keyClick(dialog.windowHandle(), Qt.Key.Key_Escape)
        return dialog.isVisible()

    for entry in ("history", "help"):
        assert not press_escape_in(entry, f"{entry}Dialog")
        driving.expect_stop(f"Esc in the {entry}")
        driving.drive()
    assert press_escape_in("bench", "benchDialog"), "the dialog stays open to show the result"
    driving.expect_stop("Esc in the bench test")
    driving.wait(lambda: not driving.program.device_manager.needs_stop)
    stops.clear()
    assert not press_escape_in("bench", "benchDialog")
    assert not press_escape_in("history", "historyDialog")
    assert stops == []


def test_escape_without_a_board_reports_no_stop(window: WindowDriver) -> None:
    window.motors.lockout = 3
    window.window.activateWindow()
    window.wait(window.window.isActiveWindow)
    QTest.keyClick(window.window.windowHandle(), Qt.Key.Key_Escape)
    assert not window.motors.locked_for
    assert window.text("motorStateLabel") == "No board is connected."


def test_disconnecting_and_closing_stop_the_motors(driving: DrivingWindow) -> None:
    driving.trigger("disconnect")
    driving.wait(lambda: is_stopped(driving.simulator))
    driving.wait(lambda: driving.device.link is ConnectionState.DISCONNECTED)
    driving.connect(driving.simulator.url)
    driving.drive()
    driving.window.close()
    driving.wait(lambda: is_stopped(driving.simulator))


def test_closing_with_edits_stops_motors_before_the_prompt(driving: DrivingWindow) -> None:
    driving.device.parameters.edit("serial_timeout", 9)
    assert not driving.window.close()
    driving.expect_stop("closing")
    assert driving.window.question.text == "There are unapplied changes."
    driving.wait_for_text("bannerText", "The window is closing, so the motors were stopped.")
    driving.click("applyFirst")
    driving.click("writeButton")
    driving.wait(lambda: not driving.device.parameters.values.pending)
    assert driving.simulator.show()["parameters"]["serial_timeout"] == 9
    assert driving.window.close()


def test_stop_pressed_while_board_is_read_is_sent(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    window.connect_port(window.program.ports.add_typed(simulator.url))
    assert window.device.link is ConnectionState.CONNECTING
    window.click("stopButton")
    window.wait(lambda: simulator.show()["counters"]["packets"] > 2)
    window.wait(lambda: is_stopped(simulator))
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)


# --- Serial timeout and other windows -----------------------------------------------------


def test_disabled_serial_timeout_is_set_with_a_click(driving: DrivingWindow) -> None:
    device = driving.device
    driving.motors.stop()
    driving.expect_stop("program")
    driving.open_page("boardPage")
    assert "Serial timeout is off" in driving.text("timeoutLabel")
    assert device.serial_timeout_s == 0
    device.parameters.edit("motor1_acceleration", 9)
    pending = device.draft.pending
    assert driving.button("timeoutButton").text()
    with driving.qtbot.waitSignal(device.applied):
        driving.click("timeoutButton")
    assert driving.simulator.show()["parameters"]["serial_timeout"] == 5
    assert device.serial_timeout_s == pytest.approx(0.5)
    assert not driving.has("timeoutButton")
    assert device.draft.pending == pending == 1, "other edits stay pending"
    assert len(device.writer.history.snapshots()) == 1


def spoken(button: QAbstractButton) -> str:
    return QAccessible.queryAccessibleInterface(button).text(QAccessible.Text.Name)


def test_stop_button_of_every_window_stops_motors(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    page = MotorsPage(connected_window, quick_simulator)
    page.motors.lockout = 0
    page.motors.accelerate = False
    assert spoken(page.button("stopButton")) == "Stop motors"
    opened: list[tuple[QWidget, QPushButton]] = []
    for open_window in WINDOWS_WITH_STOP:
        case = open_window.__name__
        window = open_window(page, tmp_path)
        page.wait(window.isVisible)
        assert not window.isModal(), case
        button = stop_button(window)
        assert spoken(button) == "Stop motors", case
        page.motors.arm()
        page.motors.set_speed(1, 60)
        page.wait_for_targets(("forward", 60), None, case)
        QTest.mousePress(button, LEFT)
        page.wait_for_targets(BRAKE, BRAKE, case)
        page.wait(lambda: quick_simulator.show()["motors"][0]["direction"] == "brake")
        assert not page.is_armed(), case
        QTest.mouseRelease(button, LEFT)
        opened.append((window, button))

    page.device.disconnect_line()
    page.wait(lambda: page.device.link is ConnectionState.DISCONNECTED)
    for window, button in opened:
        assert not button.isEnabled(), window.objectName()
        window.close()
