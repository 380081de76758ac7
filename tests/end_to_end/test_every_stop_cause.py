"""Whatever happens to the window, the motors of the board stop: the board is asked, not we.

The simulated board and the window are processes of their own.
"""

import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtDBus import QDBusConnection, QDBusMessage
from pytestqt.qtbot import QtBot

from tests.support.driven_window import AUXILIARY, HANGING, SPEEDS
from tests.support.logind import Logind, message_bus
from tests.support.simulator import SimulatedDevice
from trex_gui.system import signals

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals and POSIX signals"),
    pytest.mark.timeout(120),
]

ROOT = Path(__file__).parents[2]

PATIENCE = 20.0
"""Seconds for what takes a moment, unless somebody stands still."""


def is_driven(simulator: SimulatedDevice) -> bool:
    """Whether every motor runs as it was told."""
    shown = simulator.show()
    speeds = [
        motor["speed"] * {"forward": 1, "reverse": -1, "brake": 0}[motor["direction"]]
        for motor in shown["motors"]
    ]
    return speeds == list(SPEEDS.values()) and shown["aux"]["speed"] == AUXILIARY


def is_stopped(simulator: SimulatedDevice) -> bool:
    """Whether both motors brake fully, are told nothing else, and the auxiliary one is off."""
    shown = simulator.show()
    braked = {"direction": "brake", "speed": 127, "target_direction": "brake", "target_speed": 127}
    return shown["aux"] == {"speed": 0, "target_speed": 0} and all(
        {key: motor[key] for key in braked} == braked for motor in shown["motors"]
    )


def wait_until(happened: Callable[[], bool], patience: float = PATIENCE) -> None:
    """Fail when something does not happen."""
    begun = time.monotonic()
    while not happened():
        assert time.monotonic() - begun < patience, "it never happened"


class DrivingWindow:
    """The program in a process of its own, with every motor running.

    It is patient with itself, so that nothing but the cause stops its motors, unless its patience
    is to be the `usual` one.
    """

    def __init__(
        self, simulator: SimulatedDevice, folder: Path, patience: str = "long", **environment: str
    ) -> None:
        self.simulator = simulator
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.support.driven_window", simulator.url, patience],
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
        self._hear("driving", 60)
        wait_until(lambda: is_driven(simulator))
        self.provoke("only_watch")
        self._hear("watching")

    def _hear(self, word: str, patience: float = PATIENCE) -> None:
        assert self.process.stdout is not None
        ready, _, _ = select.select([self.process.stdout], [], [], patience)
        assert ready, f"the window never said {word}"
        assert self.process.stdout.readline() == f"{word}\n"

    def provoke(self, cause: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(f"{cause}\n")
        self.process.stdin.flush()

    def hang(self, cause: str = "hang") -> None:
        """Let it hang, and wait until it does."""
        self.provoke(cause)
        self._hear("hanging")

    def end(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()


@pytest.fixture
def start(simulator: SimulatedDevice, tmp_path: Path) -> Iterator[Callable[..., DrivingWindow]]:
    """Start a window that drives."""
    windows: list[DrivingWindow] = []

    def start(**environment: str) -> DrivingWindow:
        windows.append(DrivingWindow(simulator, tmp_path, **environment))
        return windows[-1]

    yield start
    for window in windows:
        window.end()


def status_of(process: "subprocess.Popen[str]") -> str:
    """What Linux tells of a process."""
    return Path(f"/proc/{process.pid}/status").read_text()


def stays_stopped(simulator: SimulatedDevice) -> bool:
    """Whether nothing that was on its way starts a motor again."""
    end = time.monotonic() + 0.5
    while time.monotonic() < end:
        if not is_stopped(simulator):
            return False
    return True


# --- In the program ---------------------------------------------------------------------


@pytest.mark.parametrize(
    "cause",
    [
        "mistake_in_a_slot",
        "mistake_in_a_thread",
        "mistake_nobody_can_catch",
        "mistake_in_the_line",
        "end_of_the_line_thread",
        "close",
        "disconnect_line",
        "sleep_unnoticed",
        "lose_the_gamepad",
    ],
)
def test_motors_stop_at(
    cause: str, start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()
    window.provoke(cause)
    wait_until(lambda: is_stopped(simulator))
    assert stays_stopped(simulator)


def test_a_window_that_goes_on_after_a_mistake_still_answers(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()
    window.provoke("mistake_in_a_slot")
    wait_until(lambda: is_stopped(simulator))
    window.provoke("close")
    _, errors = window.process.communicate(timeout=PATIENCE)
    assert window.process.returncode == 0
    assert "ZeroDivisionError: on purpose" in errors


@pytest.mark.parametrize("cause", ["hang", "hang_computing"])
def test_motors_stop_while_the_window_hangs(
    cause: str, start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start(patience="usual")
    window.hang(cause)
    wait_until(lambda: is_stopped(simulator), HANGING - 10)  # the motors do not wait for its end
    assert stays_stopped(simulator)


# --- From outside -----------------------------------------------------------------------


@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGQUIT], ids=lambda n: n.name
)
def test_motors_stop_at_a_signal_and_the_program_ends_well(
    number: signal.Signals, start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()
    window.process.send_signal(number)
    wait_until(lambda: is_stopped(simulator))
    assert window.process.wait(PATIENCE) == 0
    assert stays_stopped(simulator)


def test_motors_stop_before_the_program_is_suspended_and_stay_stopped_when_it_goes_on(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()
    window.process.send_signal(signal.SIGTSTP)
    wait_until(lambda: is_stopped(simulator))
    wait_until(lambda: "\nState:\tT" in status_of(window.process))
    assert stays_stopped(simulator)
    window.process.send_signal(signal.SIGCONT)
    wait_until(lambda: "\nState:\tT" not in status_of(window.process))
    assert stays_stopped(simulator)
    window.process.send_signal(signal.SIGTERM)
    assert window.process.wait(PATIENCE) == 0


def test_motors_stop_at_a_signal_to_a_window_that_hangs_and_the_program_ends_all_the_same(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()  # patient: it is not for want of a pulse
    window.hang()
    window.process.send_signal(signal.SIGTERM)
    wait_until(lambda: is_stopped(simulator))
    assert window.process.wait(PATIENCE) == 128 + signal.SIGTERM
    assert is_stopped(simulator)


def test_a_second_ctrl_c_ends_a_window_that_hangs_at_once(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()
    window.hang()
    begun = time.monotonic()
    window.process.send_signal(signal.SIGINT)
    wait_until(lambda: is_stopped(simulator))
    assert stays_stopped(simulator)
    assert window.process.poll() is None, "it would still wait for seconds"
    while window.process.poll() is None:  # one that comes too soon is taken for the first
        window.process.send_signal(signal.SIGINT)
        with suppress(subprocess.TimeoutExpired):
            window.process.wait(1)
    assert window.process.returncode == 128 + signal.SIGINT
    assert time.monotonic() - begun < signals._GRACE_S, "it has not waited"
    assert stays_stopped(simulator)


def test_nothing_helps_against_kill_9_but_the_boards_own_timeout(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    """Why the window speaks of the serial timeout beside Run motor."""
    window = start()
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    window.process.kill()
    window.process.wait(10)
    time_of_death = time.monotonic()
    while time.monotonic() < time_of_death + 2:
        assert is_driven(simulator), "nobody told it to stop"


def test_a_board_with_a_serial_timeout_stops_after_kill_9(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    set_timeout = [
        *(sys.executable, "-m", "trex_gui.cli", "set", "serial_timeout", "0.5 s"),
        *("--port", simulator.url, "--timeout", "1"),
    ]
    subprocess.run(set_timeout, check=True, capture_output=True, timeout=30)
    window = start()
    window.process.kill()
    wait_until(lambda: is_stopped(simulator))
    assert stays_stopped(simulator)


def test_trexcmd_stops_what_a_killed_window_left_running(
    start: Callable[..., DrivingWindow], simulator: SimulatedDevice
) -> None:
    window = start()
    window.process.kill()
    window.process.wait(10)
    assert is_driven(simulator)
    stop = [sys.executable, "-m", "trex_gui.cli", "stop"]
    subprocess.run(
        [*stop, "--port", simulator.url, "--timeout", "1"],
        check=True,
        capture_output=True,
        timeout=30,
    )
    assert is_stopped(simulator)


# --- From the desktop -------------------------------------------------------------------


@pytest.fixture
def bus() -> Iterator[tuple[str, QDBusConnection]]:
    """A message bus of the test's own: its address, and a connection to it."""
    with message_bus() as both:
        yield both


_LOGIN = "/org/freedesktop/login1"


@pytest.mark.parametrize(
    ("path", "interface", "name", "arguments"),
    [
        (_LOGIN, "org.freedesktop.login1.Manager", "PrepareForSleep", [True]),
        (_LOGIN, "org.freedesktop.login1.Manager", "PrepareForShutdown", [True]),
        (f"{_LOGIN}/session/_31", "org.freedesktop.login1.Session", "Lock", []),
        ("/ScreenSaver", "org.freedesktop.ScreenSaver", "ActiveChanged", [True]),
        ("/org/gnome/ScreenSaver", "org.gnome.ScreenSaver", "ActiveChanged", [True]),
    ],
)
def test_motors_stop_when_the_desktop_says(
    path: str,
    interface: str,
    name: str,
    arguments: list[Any],
    start: Callable[..., DrivingWindow],
    simulator: SimulatedDevice,
    bus: tuple[str, QDBusConnection],
) -> None:
    address, connection = bus
    start(DBUS_SESSION_BUS_ADDRESS=address, DBUS_SYSTEM_BUS_ADDRESS=address)
    # Waking up and unlocking say the same with a false: that stops nothing.
    if arguments:
        harmless = QDBusMessage.createSignal(path, interface, name)
        harmless.setArguments([False])
        assert connection.send(harmless)
    said = QDBusMessage.createSignal(path, interface, name)
    said.setArguments(arguments)
    assert is_driven(simulator)
    assert connection.send(said)
    wait_until(lambda: is_stopped(simulator))
    assert stays_stopped(simulator)


def test_sleep_is_held_up_until_the_board_has_stopped_its_motors(
    start: Callable[..., DrivingWindow],
    simulator: SimulatedDevice,
    bus: tuple[str, QDBusConnection],
    qtbot: QtBot,
) -> None:
    address, connection = bus
    logind = Logind(connection)
    start(DBUS_SESSION_BUS_ADDRESS=address, DBUS_SYSTEM_BUS_ADDRESS=address)
    qtbot.waitUntil(lambda: logind.held == 1)
    assert is_driven(simulator)
    logind.say_sleep(begins=True)
    qtbot.waitUntil(lambda: logind.held == 0)
    assert is_stopped(simulator), "now the computer sleeps"
    logind.say_sleep(begins=False)
    qtbot.waitUntil(lambda: logind.held == 1)
    logind.close()
