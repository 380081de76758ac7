"""The whole window, a gamepad that exists only in SDL, and what the simulator's motors do."""

import sys
from collections.abc import Callable, Iterator
from typing import Any, TypeVar

import pytest
from PySide6.QtWidgets import QCheckBox, QDialog, QLabel, QTabWidget, QWidget
from pytestqt.qtbot import QtBot

from tests.gamepad.virtual_pad import VirtualPad
from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.views.driving.gamepad_panel import GamepadPanel
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

HOLD, STOP = 9, 1  # of SDL's virtual gamepads: left shoulder, B
X, Y = 0, 1

WidgetT = TypeVar("WidgetT", bound=QWidget)


class Driver:
    """The Motors page with a simulated board behind it, and a gamepad in hand."""

    def __init__(self, program: Program, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.program, self.simulator, self.qtbot = program, simulator, qtbot
        self.motors = program.device.motors
        program.device.connect_to(LinkSettings(simulator.url))
        self.wait(lambda: program.device.link is Link.UP)
        self.open_page("motorsPage")
        program.window.activateWindow()
        self.wait(program.window.isActiveWindow)
        self.panel = self.find(GamepadPanel, "gamepadPanel")
        self.find(QCheckBox, "gamepadBox").setChecked(True)
        self.pad = VirtualPad()
        self.wait(lambda: self.panel.gamepad.pad is not None)

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=20_000)

    def wait_for(self, words: str) -> None:
        self.wait(lambda: words in self.find(QLabel, "gamepadState").text())

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        found = self.program.window.findChild(kind, name)
        assert isinstance(found, kind), name
        return found

    def open_page(self, name: str) -> None:
        tabs = self.find(QTabWidget, "tabs")
        page = self.find(QWidget, name)
        areas = [tabs.widget(index) for index in range(tabs.count())]
        tabs.setCurrentIndex(
            next(n for n, area in enumerate(areas) if area and area.isAncestorOf(page))
        )

    def shown(self) -> list[dict[str, Any]]:
        motors: list[dict[str, Any]] = self.simulator.show()["motors"]
        return motors

    def wait_for_motors(self, direction: str, least: int = 0) -> None:
        self.wait(
            lambda: all(
                motor["direction"] == motor["target_direction"] == direction
                and motor["speed"] >= least
                for motor in self.shown()
            )
        )

    def wait_for_stop(self) -> None:
        self.wait(
            lambda: all(
                motor["direction"] == motor["target_direction"] == "brake" for motor in self.shown()
            )
        )

    def drive(self) -> None:
        """Forward, as fast as it goes."""
        self.motors.arm()
        self.wait_for("Hold")
        self.pad.press(HOLD)
        self.wait_for("Driving")
        self.pad.move(Y, -1.0)
        self.wait_for_motors("forward", 40)


@pytest.fixture
def driver(program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[Driver]:
    driver = Driver(program, quick_simulator, qtbot)
    driver.motors.lockout = 0
    yield driver
    driver.panel.gamepad.switch_off()


def test_the_gamepad_drives_and_letting_go_brakes(driver: Driver) -> None:
    driver.drive()
    driver.pad.press(HOLD, down=False)
    driver.wait_for_stop()
    assert driver.motors.armed


def test_a_gamepad_unplugged_in_full_drive_stops_the_motors(driver: Driver) -> None:
    driver.drive()
    driver.pad.unplug()
    driver.wait_for_stop()
    driver.wait_for("has gone")
    assert not driver.motors.armed


def test_its_stop_button_stops_the_motors(driver: Driver) -> None:
    driver.drive()
    driver.pad.press(STOP)
    driver.wait_for_stop()
    assert not driver.motors.armed


def test_leaving_the_page_in_full_drive_stops_the_motors(driver: Driver) -> None:
    driver.drive()
    driver.open_page("statusPage")
    driver.wait_for_stop()
    assert not driver.motors.armed


@pytest.mark.parametrize("page", ["statusPage", "currentsPage", "parametersPage"])
def test_its_stop_button_works_on_other_pages(driver: Driver, page: str) -> None:
    driver.open_page(page)
    driver.motors.arm()
    driver.motors.set_speed(1, 60)
    driver.motors.set_speed(2, 60)
    driver.wait_for_motors("forward", 10)
    driver.pad.press(STOP)
    driver.wait_for_stop()


def test_another_window_in_front_stops_the_motors(driver: Driver, qtbot: QtBot) -> None:
    driver.drive()
    other = QDialog()
    qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    driver.wait_for_stop()


def test_switching_it_off_in_full_drive_stops_the_motors(driver: Driver) -> None:
    driver.drive()
    driver.find(QCheckBox, "gamepadBox").setChecked(False)
    driver.wait_for_stop()


def test_a_gamepad_held_while_the_motors_are_armed_moves_nothing(driver: Driver) -> None:
    driver.pad.press(HOLD)
    driver.pad.move(Y, -1.0)
    driver.wait(lambda: driver.panel.gamepad.state is not None)
    driver.motors.arm()
    driver.wait_for("Let go")
    assert all(
        motor["target_speed"] == 0 or motor["target_direction"] == "brake"
        for motor in driver.shown()
    )
    driver.motors.stop()
