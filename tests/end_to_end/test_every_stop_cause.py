"""Motors stop at every failure of the window.

The simulated board and the window run in separate processes.
"""

import os
import re
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtDBus import QDBusConnection, QDBusMessage
from pytestqt.qtbot import QtBot

from tests.devices.trex.recording.samples import read_file
from tests.support.driven_window import AUXILIARY, SPEEDS
from tests.support.logind import Logind, message_bus
from tests.support.matrix import sampled
from tests.support.pages.motors import is_stopped, signed_speeds
from tests.support.simulator import SimulatedDevice
from trex_gui.core.signals import ENDING
from trex_gui.supervisor import INTERNAL_ERROR

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals and POSIX signals"),
    pytest.mark.timeout(120),
]

ROOT = Path(__file__).parents[2]

LONG_TIMEOUT = 25.0
"""Seconds for actions that are short on a quiet computer. A window hangs for longer."""

PAUSE = 0.02
"""Seconds between two polls of the simulator."""

POLLS = 20
"""Packets after which a working line would have sent a setpoint."""


def is_driven(simulator: SimulatedDevice) -> bool:
    """Return whether every motor runs at its setpoint."""
    auxiliary = simulator.show()["aux"]["speed"]
    return signed_speeds(simulator) == list(SPEEDS.values()) and auxiliary == AUXILIARY


def wait_until(condition: Callable[[], bool], cause: str = "") -> None:
    """Poll a condition in real time. Fail after a timeout."""
    end = time.monotonic() + LONG_TIMEOUT
    while not condition():
        assert time.monotonic() < end, f"{cause}: timeout"
        time.sleep(PAUSE)


class DrivingProcess:
    """The program in a separate process.

    Unless `timeouts` is "default", they are long, so only the tested cause stops the motors.
    """

    def __init__(
        self,
        simulator: SimulatedDevice,
        folder: Path,
        timeouts: str = "long",
        baud: str = "19200",
        **environment: str,
    ) -> None:
        self.simulator = simulator
        self.guardian_log = folder / "guardian.log"
        program = [sys.executable, "-m", "tests.support.driven_window"]
        self.process = subprocess.Popen(
            [*program, simulator.url, timeouts, baud],
            cwd=ROOT,
            env={
                **os.environ,
                "QT_QPA_PLATFORM": "offscreen",
                "XDG_CONFIG_HOME": str(folder),
                "TREX_STUDIO_DATA": str(folder),
                **environment,
            },
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def drive(self) -> None:
        self.send("drive")
        self.expect("driving")
        wait_until(lambda: is_driven(self.simulator))
        self.wait_for_reply()

    def wait_for_reply(self) -> None:
        """Wait until the event loop of the window has processed a command."""
        self.send("stop_rearming")
        self.expect("rearming_stopped")

    def expect(self, word: str) -> None:
        assert self.process.stdout is not None
        ready, _, _ = select.select([self.process.stdout], [], [], LONG_TIMEOUT)
        assert ready, f"the window never printed {word}"
        assert self.process.stdout.readline() == f"{word}\n"

    def send(self, command: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(f"{command}\n")
        self.process.stdin.flush()

    def hang(self, cause: str = "hang") -> None:
        """Make the window hang, and wait until it hangs."""
        self.send(cause)
        self.expect("hanging")

    def errors(self) -> str:
        """Return the console output after the process has ended."""
        return self.process.communicate(timeout=LONG_TIMEOUT)[1]

    def end(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()


StartWindow = Callable[..., DrivingProcess]


@pytest.fixture
def start(quick_simulator: SimulatedDevice, tmp_path: Path) -> Iterator[StartWindow]:
    """Function that starts a window."""
    windows: list[DrivingProcess] = []

    def start(**environment: str) -> DrivingProcess:
        windows.append(DrivingProcess(quick_simulator, tmp_path, **environment))
        return windows[-1]

    yield start
    for window in windows:
        window.end()


def status_of(process: "subprocess.Popen[str]") -> str:
    """Return the status of a process. Works on Linux only."""
    return Path(f"/proc/{process.pid}/status").read_text()


def wait_until_stopped(simulator: SimulatedDevice, cause: str) -> None:
    wait_until(lambda: is_stopped(simulator), cause)


def assert_stays_stopped(window: DrivingProcess, cause: str) -> None:
    """Fail if a motor runs after the window has processed events and polled the board."""
    window.wait_for_reply()
    polled = received_packets(window.simulator) + POLLS
    wait_until(lambda: received_packets(window.simulator) >= polled, cause)
    assert is_stopped(window.simulator), f"{cause}: a motor runs again"


def received_packets(simulator: SimulatedDevice) -> int:
    count: int = simulator.show()["counters"]["packets"]
    return count


# --- Inside the program -----------------------------------------------------------------


def test_motors_stop_at_every_fault_the_program_survives(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start()
    for cause in (
        "error_in_a_slot",
        "error_in_a_thread",
        "exit_in_a_thread",
        "interrupt_in_a_slot",
        "error_in_an_event_filter",
        "error_while_painting",
        "error_in_a_destructor",
        "sleep_unnoticed",
        "lose_the_gamepad",
    ):
        window.drive()
        window.send(cause)
        wait_until_stopped(quick_simulator, cause)
        assert_stays_stopped(window, cause)
    window.drive()
    window.send("close")
    wait_until_stopped(quick_simulator, "close")
    _, errors = window.process.communicate(timeout=LONG_TIMEOUT)
    assert window.process.returncode == 0
    exceptions = re.findall("(.*): on purpose", errors)
    assert exceptions == [
        "ZeroDivisionError",
        "IndexError",
        "KeyboardInterrupt",
        "LookupError",
        "ArithmeticError",
        "RecursionError",
    ]


def test_motors_stop_when_the_line_thread_ends(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start()
    window.drive()
    window.send("end_of_the_line_thread")
    wait_until_stopped(quick_simulator, "end of the line thread")


@pytest.mark.parametrize("cause", ["hang_computing", pytest.param("hang", marks=pytest.mark.slow)])
def test_motors_stop_while_window_hangs(
    cause: str, start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start(timeouts="default")
    window.drive()
    window.hang(cause)
    wait_until_stopped(quick_simulator, cause)  # while the window still hangs


# --- Outside the program ----------------------------------------------------------------


@pytest.mark.slow  # the next test covers SIGTERM
@pytest.mark.parametrize("name", ["SIGTERM", *ENDING[5:]])
def test_ending_signal_stops_motors_and_exits_with_0(
    name: str, start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    if not hasattr(signal, name):
        pytest.skip("this system has no such signal")
    window = start()
    window.drive()
    window.process.send_signal(getattr(signal, name))
    assert window.process.wait(LONG_TIMEOUT) == 0
    assert is_stopped(quick_simulator)
    assert "guardian" not in window.errors()


def test_ctrl_z_and_sigterm_stop_motors_and_resuming_starts_none(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start()
    window.drive()
    for number in (signal.SIGTTIN, signal.SIGTTOU):  # a terminal in the background
        window.process.send_signal(number)
        window.wait_for_reply()
    assert is_driven(quick_simulator)
    window.process.send_signal(signal.SIGTSTP)
    wait_until_stopped(quick_simulator, "SIGTSTP")
    wait_until(lambda: "\nState:\tT" in status_of(window.process))
    window.process.send_signal(signal.SIGCONT)
    wait_until(lambda: "\nState:\tT" not in status_of(window.process))
    assert_stays_stopped(window, "SIGCONT")
    window.drive()
    window.process.send_signal(signal.SIGTERM)
    assert window.process.wait(LONG_TIMEOUT) == 0
    assert is_stopped(quick_simulator)
    assert "guardian" not in window.errors()


@pytest.mark.parametrize("disk", sampled(["slow", "hanging"], every=2))
def test_sigterm_while_recording_ends_program_cleanly(
    disk: str, start: StartWindow, tmp_path: Path
) -> None:
    window = start()
    window.send(f"record_on_a_{disk}_disk")
    window.expect("recording")
    window.process.send_signal(signal.SIGTERM)
    errors = window.errors()
    assert window.process.returncode == 0
    assert "QThread" not in errors
    assert "Traceback" not in errors
    if disk == "slow":
        _, records, problems = read_file(tmp_path / "a.trexrec")
        assert problems == []
        assert len(records) > 50


@pytest.mark.slow  # the program waits for its window before it ends
def test_sigterm_stops_motors_of_hung_window_and_ends_it(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start()  # with a long heartbeat timeout, which stops no motor
    window.drive()
    window.hang()
    window.process.send_signal(signal.SIGTERM)
    wait_until_stopped(quick_simulator, "SIGTERM")
    assert window.process.wait(LONG_TIMEOUT) == 128 + signal.SIGTERM


@pytest.mark.parametrize(
    "cause",
    ["exit_in_a_slot", pytest.param("exit_in_a_signal_handler", marks=pytest.mark.slow)],
)
def test_exit_in_event_handler_stops_motors_and_exits_with_1(
    cause: str, start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    """PySide exits the interpreter at once. Then Qt aborts, because the line thread still runs."""
    window = start()
    window.drive()
    window.send(cause)
    assert window.process.wait(LONG_TIMEOUT) == INTERNAL_ERROR
    assert is_stopped(quick_simulator)
    assert "guardian" not in window.errors()


_SIGNALS = [
    pytest.param(signal.SIGKILL, marks=pytest.mark.slow),
    signal.SIGSEGV,
    *(pytest.param(each, marks=pytest.mark.slow) for each in (signal.SIGABRT, signal.SIGBUS)),
]


@pytest.mark.parametrize("number", _SIGNALS)
def test_guardian_stops_motors_of_a_killed_window(
    number: signal.Signals, start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    """The serial timeout of the board is off by default."""
    window = start()
    window.drive()
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0
    window.process.send_signal(number)
    wait_until_stopped(quick_simulator, number.name)
    assert_guardian_confirms(window, "The program ended")


def test_guardian_stops_motors_after_the_session_lost_the_port(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start()
    window.drive()
    window.send("close_the_descriptor")
    wait_until_stopped(quick_simulator, "closed descriptor")
    window.send("close")
    assert_guardian_confirms(window, "The program requested a stop")


def test_guardian_stops_motors_while_the_line_hangs(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start(timeouts="default")
    window.drive()
    window.hang("hang_the_line")
    wait_until_stopped(quick_simulator, "hanging line")
    window.process.kill()
    assert_guardian_confirms(window, "The program did not respond")


def test_guardian_stops_motors_while_the_process_is_suspended(
    start: StartWindow, quick_simulator: SimulatedDevice
) -> None:
    window = start(timeouts="default")
    window.drive()
    window.process.send_signal(signal.SIGSTOP)
    wait_until_stopped(quick_simulator, "SIGSTOP")
    window.process.send_signal(signal.SIGCONT)
    assert_stays_stopped(window, "SIGCONT")
    window.send("close")
    _, errors = window.process.communicate(timeout=LONG_TIMEOUT)
    assert "The program did not respond while motors could move." in errors


def assert_guardian_confirms(window: DrivingProcess, reason: str) -> None:
    """Wait until the guardian ends, and check its report."""
    _, errors = window.process.communicate(timeout=LONG_TIMEOUT)
    report = f"{reason} while motors could move. The stop was sent and is confirmed."
    assert report in errors
    assert report in window.guardian_log.read_text(encoding="utf-8")


# --- From the desktop -------------------------------------------------------------------


@pytest.fixture
def bus() -> Iterator[tuple[str, QDBusConnection]]:
    """Private message bus: its address and a connection."""
    with message_bus() as bus:
        yield bus


_LOGIN = "/org/freedesktop/login1"


def test_desktop_signals_stop_motors_before_the_computer_sleeps(
    start: StartWindow,
    quick_simulator: SimulatedDevice,
    bus: tuple[str, QDBusConnection],
    qtbot: QtBot,
) -> None:
    address, connection = bus
    logind = Logind(connection)
    window = start(DBUS_SESSION_BUS_ADDRESS=address, DBUS_SYSTEM_BUS_ADDRESS=address)
    qtbot.waitUntil(lambda: logind.held == 1)
    window.drive()
    logind.announce_sleep(begins=True)
    qtbot.waitUntil(lambda: logind.held == 0)
    assert is_stopped(quick_simulator), "stopped before the computer sleeps"
    logind.announce_sleep(begins=False)
    qtbot.waitUntil(lambda: logind.held == 1)

    signals: tuple[tuple[str, str, str, list[Any]], ...] = (
        (_LOGIN, "org.freedesktop.login1.Manager", "PrepareForShutdown", [True]),
        ("/ScreenSaver", "org.freedesktop.ScreenSaver", "ActiveChanged", [True]),
        ("/org/gnome/ScreenSaver", "org.gnome.ScreenSaver", "ActiveChanged", [True]),
        (f"{_LOGIN}/session/_31", "org.freedesktop.login1.Session", "Lock", []),
    )
    for path, interface, name, arguments in signals:
        window.drive()
        message = QDBusMessage.createSignal(path, interface, name)
        message.setArguments(arguments)
        assert connection.send(message)
        wait_until_stopped(quick_simulator, name)
    logind.close()
