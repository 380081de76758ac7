"""Bench tests in the window: a finger on the button, a simulated board in a process of its own."""

import sys
from collections.abc import Callable
from typing import TypeVar

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QLabel, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.bench.profile import Profile
from trex_gui.bench.run import End
from trex_gui.link.settings import LinkSettings
from trex_gui.model.bench import Bench, Phase, Plan
from trex_gui.model.device import Link
from trex_gui.views.bench.dialog import BenchDialog
from trex_gui.views.bench.hold_button import HoldButton
from trex_gui.views.bench.opener import BenchOpener
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

WidgetT = TypeVar("WidgetT", bound=QWidget)


class Person:
    """Somebody who has opened the window of bench tests."""

    def __init__(self, program: Program, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.program = program
        self.simulator = simulator
        self._qtbot = qtbot
        program.device.connect_to(LinkSettings(simulator.url))
        self.wait(lambda: program.device.link is Link.UP)
        self.wait(lambda: program.device.telemetry.motor_currents is not None)
        program.window.findChild(QAction, "benchAction").trigger()  # type: ignore[union-attr]
        self.dialog = self.find(BenchDialog, "benchDialog")
        self.button = self.find(HoldButton, "benchHoldButton")
        self.bench.set_plan(Plan(profile=Profile(speed=60, duration=20.0), abort_current=30.0))

    @property
    def bench(self) -> Bench:
        opener = self.program.window.findChild(BenchOpener)
        assert isinstance(opener, BenchOpener)
        return opener.bench

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.program.window.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def wait(self, condition: Callable[[], bool]) -> None:
        self._qtbot.waitUntil(condition, timeout=20_000)

    def click(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        self.wait(button.isEnabled)
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def hold(self) -> None:
        """Run motor, then press the button and keep it down until the motor runs."""
        self.click("benchRunButton")
        self.dialog.activateWindow()
        self.button.setFocus()
        self.wait(self.button.hasFocus)
        QTest.mousePress(self.button, Qt.MouseButton.LeftButton)
        self.wait(lambda: self.speed() == 60)

    def speed(self) -> int:
        """What the simulated output of motor 1 does; 0 while it brakes."""
        motor = self.simulator.show()["motors"][0]
        return 0 if motor["direction"] == "brake" else int(motor["speed"])

    def stands(self) -> None:
        """Wait until the simulated motor brakes, and the test is over."""
        self.wait(lambda: self.speed() == 0)
        self.wait(lambda: self.bench.phase is Phase.IDLE)


@pytest.fixture
def person(program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot) -> Person:
    return Person(program, quick_simulator, qtbot)


def test_a_motor_runs_while_the_button_is_held_and_brakes_when_it_is_let_go(
    person: Person,
) -> None:
    person.hold()
    QTest.mouseRelease(person.button, Qt.MouseButton.LeftButton)
    person.stands()
    assert person.bench.runs[-1].end is End.LET_GO
    assert person.program.device.motors.armed
    assert "Let go after" in person.find(QLabel, "benchNote").text()


def test_the_space_bar_does_the_same(person: Person) -> None:
    person.click("benchRunButton")
    person.dialog.activateWindow()
    person.button.setFocus()
    person.wait(person.button.hasFocus)
    QTest.keyPress(person.button, Qt.Key.Key_Space)
    person.wait(lambda: person.speed() == 60)
    QTest.keyRelease(person.button, Qt.Key.Key_Space)
    person.stands()
    assert person.bench.runs[-1].end is End.LET_GO


def test_escape_stops_the_motor_and_locks_it(person: Person) -> None:
    person.hold()
    QTest.keyClick(person.button, Qt.Key.Key_Escape)
    person.stands()
    motors = person.program.device.motors
    assert person.bench.runs[-1].reason == "Stop was pressed."
    assert not motors.armed
    assert motors.locked_for > 0
    assert person.dialog.isVisible()


def test_the_red_button_of_the_window_stops_it_too(person: Person) -> None:
    person.hold()
    person.click("benchStopButton")
    person.stands()
    assert not person.program.device.motors.armed
    assert not person.button.isEnabled()


def test_closing_the_window_of_the_test_stops_the_motor(person: Person) -> None:
    person.hold()
    person.dialog.close()
    assert not person.dialog.isVisible()
    person.stands()
    assert not person.program.device.motors.armed


def test_the_window_closes_with_its_button_and_opens_again(person: Person) -> None:
    for _ in range(2):
        person.click("benchCloseButton")
        assert not person.dialog.isVisible()
        person.program.window.findChild(QAction, "benchAction").trigger()  # type: ignore[union-attr]
        assert person.dialog.isVisible()
    person.hold()
    QTest.mouseRelease(person.button, Qt.MouseButton.LeftButton)
    person.stands()


def test_closing_the_program_stops_the_motor(person: Person) -> None:
    person.hold()
    person.program.window.close()
    person.wait(lambda: person.speed() == 0)


def test_disconnecting_stops_the_motor(person: Person) -> None:
    person.hold()
    person.click("connectButton")
    person.stands()
    assert person.bench.runs[-1].end is End.ABORTED


def test_too_high_a_current_stops_the_motor_and_the_window_says_so(person: Person) -> None:
    person.hold()
    person.simulator.do("current 1 31.5")
    person.stands()
    person.simulator.do("current 1 auto")
    assert "Motor 1 drew 31.50 A, more than the 30 A" in person.find(QLabel, "benchNote").text()
    assert not person.program.device.motors.armed


def test_settings_are_tuned_beside_the_result_through_the_review(person: Person) -> None:
    editor = person.find(QSpinBox, "bench_motor1_acceleration")
    editor.setValue(25)
    assert "Acceleration (stored: no ramp)" in person.find(QLabel, "benchEdited").text()
    person.click("benchApplyButton")
    person.click("writeButton")
    person.wait(lambda: person.simulator.show()["parameters"]["motor1_acceleration"] == 25)
    person.wait(lambda: person.find(QLabel, "benchEdited").isHidden())


def test_the_editors_are_those_of_the_motor_under_test(person: Person) -> None:
    person.bench.set_plan(Plan(motor=2))
    person.find(QSpinBox, "bench_motor2_current_limit").setValue(30)
    assert person.program.device.parameters.value_of("motor2_current_limit") == 30
    assert person.program.device.parameters.value_of("motor1_current_limit") == 0
