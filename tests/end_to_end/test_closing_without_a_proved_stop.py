"""A window that closes while motors may still turn says so before it goes."""

import signal
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from tests.end_to_end.test_every_stop_cause import PATIENCE, DrivingWindow, is_stopped
from tests.support.simulator import SimulatorProcess
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.app import UNSTOPPED
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.runtime import runtime
from trex_gui.views.last_warning import LastWarning
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

WARNING = "The stop is not confirmed. If a motor still turns, cut its power."


class Driven:
    """A window that has driven a board which does not answer any more, though it obeys."""

    def __init__(self, program: Program, simulator: VirtualSimulator, qtbot: QtBot) -> None:
        self.program, self.window, self.device = program, program.window, program.device
        self.simulator, self.qtbot = simulator, qtbot
        self.connect()
        self.device.motors.arm()
        self.device.motors.set_speed(1, 60)
        self.wait_for(self.is_driven)
        simulator.do("line mute on")

    def is_driven(self) -> bool:
        return bool(self.simulator.show()["motors"][0]["speed"] == 60)

    def connect(self) -> None:
        self.device.connect_to(LinkSettings(self.simulator.url))
        self.qtbot.waitUntil(lambda: self.device.link is Link.UP and self.device.motors.can_arm)

    def wait_for(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=40_000)

    @property
    def asked(self) -> str:
        return self.window.question.text

    def press(self, name: str) -> None:
        self.qtbot.waitUntil(self.window.question.isVisible)
        button = self.window.question.findChild(QPushButton, name)
        assert button is not None, name
        button.click()


@pytest.fixture
def driven(program: Program, quick_simulator: VirtualSimulator, qtbot: QtBot) -> Driven:
    return Driven(program, quick_simulator, qtbot)


def test_the_window_asks_to_cut_the_power_and_goes_when_that_was_read(driven: Driven) -> None:
    assert not driven.window.close()
    assert driven.window.isVisible()
    assert driven.asked == WARNING
    driven.press("closeUnstopped")
    assert not driven.window.isVisible()


def test_who_closes_it_again_has_read_it(driven: Driven) -> None:
    assert not driven.window.close()
    assert driven.window.close()
    assert not driven.window.isVisible()


def test_who_stays_is_told_again_with_the_next_closing(driven: Driven) -> None:
    driven.window.close()
    driven.press("questionCancel")
    assert driven.asked == ""
    assert driven.window.isVisible()
    assert not driven.window.close()
    assert driven.asked == WARNING


def test_edits_are_not_asked_about_twice(driven: Driven) -> None:
    driven.device.parameters.edit("serial_timeout", 15)
    assert not driven.window.close()
    driven.press("closeYes")
    assert driven.asked == WARNING
    driven.press("closeUnstopped")
    assert not driven.window.isVisible()


def test_who_connects_again_has_the_stop_proved_and_is_not_asked_any_more(driven: Driven) -> None:
    driven.window.close()
    driven.simulator.do("line mute off")
    driven.connect()
    assert driven.asked == ""
    assert not driven.device.may_move
    assert driven.window.close()


def test_a_stop_of_which_is_heard_too_late_closes_the_window_after_all(
    driven: Driven,
) -> None:
    driven.simulator.do("line mute off")
    driven.simulator.on_close = lambda: runtime().sleep(10)
    assert not driven.window.close()
    assert driven.asked == WARNING
    driven.wait_for(lambda: not driven.window.isVisible())
    assert not driven.device.may_move
    assert is_stopped(driven.simulator)


def test_nobody_is_asked_who_logs_out(driven: Driven) -> None:
    warning = driven.window.findChild(LastWarning)
    assert warning is not None
    warning.note_log_out()
    assert driven.window.close()
    assert driven.device.may_move


def test_a_window_that_has_proved_its_stop_just_closes(
    program: Program, quick_simulator: VirtualSimulator, qtbot: QtBot
) -> None:
    driven = Driven(program, quick_simulator, qtbot)
    quick_simulator.do("line mute off")
    driven.device.motors.press_stop()
    qtbot.waitUntil(lambda: not driven.device.may_move)
    assert driven.window.close()
    assert driven.asked == ""


@pytest.mark.realtime
def test_a_program_that_a_signal_ends_without_a_proved_stop_says_so_and_fails(
    quick_simulator: SimulatorProcess, tmp_path: Path
) -> None:
    window = DrivingWindow(quick_simulator, tmp_path, patience="usual")
    try:
        window.drive()
        quick_simulator._process.send_signal(signal.SIGSTOP)
        window.process.send_signal(signal.SIGTERM)
        _, errors = window.process.communicate(timeout=PATIENCE)
    finally:
        quick_simulator._process.send_signal(signal.SIGCONT)
        window.end()
    assert WARNING in errors
    assert window.process.returncode == UNSTOPPED
