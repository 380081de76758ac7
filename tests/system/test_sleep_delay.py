"""Sleep waits up to a second until the motors stop if logind grants a delay."""

import shutil
import time
from collections.abc import Iterator

import pytest
from PySide6.QtDBus import QDBusConnection
from pytestqt.qtbot import QtBot

from tests.support.logind import Logind, connection_to, message_bus
from trex_gui.system.login_session import SessionEvents, SleepDelay

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(shutil.which("dbus-daemon") is None, reason="needs a message bus"),
    pytest.mark.usefixtures("qapp"),
]


@pytest.fixture
def buses() -> Iterator[tuple[QDBusConnection, QDBusConnection]]:
    """Connections of logind and of the program to a bus."""
    with message_bus() as (address, logind), connection_to(address) as program:
        yield logind, program


class SleepHarness:
    """Computer that can sleep, and a program whose motors may move."""

    def __init__(self, logind: QDBusConnection, program: QDBusConnection, qtbot: QtBot) -> None:
        self.may_move = True
        self.qtbot = qtbot
        self.logind = Logind(logind)
        self.delay = SleepDelay(lambda: self.may_move, program, timeout=1.0)
        self.events = SessionEvents(program, program)
        self.events.sleeping.connect(self.delay.on_sleeping)
        qtbot.waitUntil(lambda: self.delay.is_active)

    @property
    def waited_ms(self) -> int:
        """Milliseconds in which the program has polled the motors."""
        return self.delay._wait._polls * self.delay._wait._timer.interval()

    def start_sleep(self) -> None:
        with self.qtbot.waitSignal(self.events.sleeping):
            self.logind.announce_sleep(begins=True)


@pytest.fixture
def harness(buses: tuple[QDBusConnection, QDBusConnection], qtbot: QtBot) -> Iterator[SleepHarness]:
    harness = SleepHarness(*buses, qtbot)
    yield harness
    harness.delay.release()
    harness.logind.close()


def test_sleep_delay_is_requested_and_held(harness: SleepHarness) -> None:
    [(what, who, why, mode)] = harness.logind.requested
    assert (what, who, mode) == ("sleep", "TReX Studio", "delay")
    assert "motors" in why
    assert harness.logind.held == 1


def test_sleep_is_delayed_only_until_motors_stop(harness: SleepHarness, qtbot: QtBot) -> None:
    harness.start_sleep()
    qtbot.waitUntil(lambda: harness.waited_ms >= 100, timeout=15_000)
    assert harness.logind.held == 1
    harness.may_move = False
    qtbot.waitUntil(lambda: harness.logind.held == 0, timeout=15_000)
    assert harness.waited_ms < 500, "the delay ends before its timeout of a second"


def test_sleep_delay_times_out_if_motors_keep_moving(harness: SleepHarness, qtbot: QtBot) -> None:
    harness.start_sleep()
    start = time.monotonic()
    qtbot.waitUntil(lambda: harness.logind.held == 0, timeout=15_000)
    assert time.monotonic() - start > 0.8
    assert harness.waited_ms == 1000


def test_sleep_delay_is_requested_again_after_wake(harness: SleepHarness, qtbot: QtBot) -> None:
    harness.may_move = False
    harness.start_sleep()
    qtbot.waitUntil(lambda: harness.logind.held == 0)
    harness.logind.announce_sleep(begins=False)
    qtbot.waitUntil(lambda: harness.logind.held == 1)
    assert len(harness.logind.requested) == 2


def test_sleep_delay_is_released_on_close(harness: SleepHarness) -> None:
    harness.delay.release()
    assert harness.logind.held == 0
    assert not harness.delay.is_active


def test_sleep_delay_without_logind_holds_nothing(
    buses: tuple[QDBusConnection, QDBusConnection], qtbot: QtBot
) -> None:
    delay = SleepDelay(lambda: False, buses[1], timeout=1.0)
    qtbot.waitUntil(lambda: delay._request is None)
    assert not delay.is_active
    delay.on_sleeping(is_starting=True)
    delay.release()


def test_sleep_delay_without_bus_holds_nothing() -> None:
    delay = SleepDelay(lambda: False, QDBusConnection("no bus"), timeout=1.0)
    delay.on_sleeping(is_starting=True)
    delay.on_sleeping(is_starting=False)
    assert not delay.is_active
    delay.release()
