"""A warning appears before the window closes while motors may still turn."""

import signal
import sys
from pathlib import Path

import pytest

from tests.end_to_end.test_every_stop_cause import LONG_TIMEOUT, DrivingProcess
from tests.support.pages.motors import is_stopped
from tests.support.simulator import SimulatorProcess
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.supervisor import UNCONFIRMED_STOP
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.frame.stopping import UnconfirmedStopWarning
from trex_gui.ui.runtime import runtime

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

WARNING = "The stop is not confirmed. If a motor is still turning, cut its power."


class UnconfirmedStopWindow(WindowDriver):
    """Window of a board that runs a motor and obeys commands, but no longer replies."""

    def __init__(self, window: WindowDriver, simulator: VirtualSimulator) -> None:
        super().__init__(window.program, window.qtbot)
        self.simulator = simulator
        self.connect_board()
        self.motors.arm()
        self.motors.set_speed(1, 60)
        self.wait(self.is_running)
        simulator.do("line mute on")

    def is_running(self) -> bool:
        return bool(self.simulator.show()["motors"][0]["speed"] == 60)

    def connect_board(self) -> None:
        self.device.connect_to(ConnectionSettings(self.simulator.url))
        self.wait(
            lambda: self.device.link is ConnectionState.CONNECTED and self.motors.is_available
        )

    @property
    def prompt(self) -> str:
        return self.window.question.text


@pytest.fixture
def running(window: WindowDriver, quick_simulator: VirtualSimulator) -> UnconfirmedStopWindow:
    return UnconfirmedStopWindow(window, quick_simulator)


def test_closing_is_refused_once_with_a_warning(running: UnconfirmedStopWindow) -> None:
    assert not running.window.close()
    assert running.window.isVisible()
    assert running.prompt == WARNING
    running.click("questionCancel")
    assert running.prompt == ""
    assert running.window.isVisible()
    assert not running.window.close()
    assert running.prompt == WARNING
    assert running.window.close()
    assert not running.window.isVisible()


def test_unapplied_edits_are_confirmed_once_before_warning(running: UnconfirmedStopWindow) -> None:
    running.device.parameters.edit("serial_timeout", 15)
    assert not running.window.close()
    running.click("closeYes")
    assert running.prompt == WARNING
    running.click("closeUnstopped")
    assert not running.window.isVisible()


def test_reconnecting_confirms_stop_and_clears_warning(running: UnconfirmedStopWindow) -> None:
    running.window.close()
    running.simulator.do("line mute off")
    running.connect_board()
    assert running.prompt == ""
    assert not running.device.may_move
    assert running.window.close()


def test_late_stop_confirmation_closes_the_window(running: UnconfirmedStopWindow) -> None:
    running.simulator.do("line mute off")
    running.simulator.on_close = lambda: runtime().sleep(10)
    assert not running.window.close()
    assert running.prompt == WARNING
    running.wait(lambda: not running.window.isVisible(), 40_000)
    assert not running.device.may_move
    assert is_stopped(running.simulator)


def test_logging_out_closes_without_a_warning(running: UnconfirmedStopWindow) -> None:
    running.find_only(UnconfirmedStopWarning).record_log_out()
    assert running.window.close()
    assert running.device.may_move


@pytest.mark.realtime
def test_sigterm_with_unconfirmed_stop_prints_warning_and_fails(
    quick_simulator: SimulatorProcess, tmp_path: Path
) -> None:
    window = DrivingProcess(quick_simulator, tmp_path, timeouts="default")
    try:
        window.drive()
        quick_simulator._process.send_signal(signal.SIGSTOP)
        window.process.send_signal(signal.SIGTERM)
        _, errors = window.process.communicate(timeout=LONG_TIMEOUT)
    finally:
        quick_simulator._process.send_signal(signal.SIGCONT)
        window.end()
    assert WARNING in errors
    assert window.process.returncode == UNCONFIRMED_STOP
