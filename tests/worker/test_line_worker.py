"""A real thread on a real pseudo-terminal."""

import os
import sys
import threading
import time
from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.link.messages import (
    Ask,
    Batch,
    Closed,
    Connected,
    Outcome,
    Report,
    SetDrive,
    Stop,
    Write,
)
from trex_gui.link.session import Session
from trex_gui.link.settings import LinkSettings
from trex_gui.protocol.commands import Drive, GetParameter
from trex_gui.protocol.errors import BadReply, NoReply, PortUnavailable
from trex_gui.worker.line_worker import LineWorker

pytestmark = pytest.mark.realtime

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)


class Watched:
    """A worker and everything that it reported."""

    def __init__(self, url: str, qtbot: QtBot) -> None:
        self.reports: list[Report] = []
        self.threads: set[threading.Thread] = set()
        self.url = url
        settings = LinkSettings(url)
        self.worker = LineWorker(lambda inbox, tell: Session(settings, inbox, tell))
        self.worker.reported.connect(self._take)
        self.qtbot = qtbot

    def _take(self, report: Report) -> None:
        self.threads.add(threading.current_thread())
        self.reports.append(report)

    def has(self, kind: type) -> bool:
        return any(isinstance(report, kind) for report in self.reports)

    def wait(self, kind: type) -> None:
        self.qtbot.waitUntil(lambda: self.has(kind))

    def connect(self) -> bool:
        """Connect; return whether it came to that: a simulator may stand still just then."""
        self.worker.start()
        self.qtbot.waitUntil(lambda: self.has(Connected) or self.has(Closed))
        return self.has(Connected)

    def outcome(self, number: int) -> Outcome:
        """Wait for the outcome of a request."""

        def found() -> list[Outcome]:
            return [one for one in self.reports if isinstance(one, Outcome) and one.id == number]

        self.qtbot.waitUntil(lambda: bool(found()))
        (outcome,) = found()
        return outcome

    @property
    def end(self) -> Closed:
        """The last report."""
        closed = self.reports[-1]
        assert isinstance(closed, Closed)
        return closed


Watch = Callable[[str], Watched]

TRIES = 4
"""How often what takes too long, or fails, is tried: a computer that stands still spoils one."""


def is_soon(seconds: float, take: Callable[[], float]) -> bool:
    """Whether something that is measured anew by each call takes less than this, once at least."""
    return any(take() < seconds for _ in range(TRIES))


@pytest.fixture
def watch(qtbot: QtBot) -> Iterator[Watch]:
    """Make workers; none may run on when the test is over."""
    watched: list[Watched] = []

    def make(url: str) -> Watched:
        watched.append(Watched(url, qtbot))
        return watched[-1]

    yield make
    for one in watched:
        if one.worker.isRunning():
            assert one.worker.close(15_000), "the thread lives on"


def connected(watch: Watch, url: str) -> Watched:
    """Return a worker that is connected to a simulated board."""
    for _ in range(TRIES):
        watched = watch(url)
        if watched.connect():
            return watched
        assert isinstance(watched.end.error, NoReply | BadReply), watched.end
    raise AssertionError(watched.end)


@pytest.fixture
def line(quick_simulator: SimulatedDevice, watch: Watch) -> Watched:
    """A worker that is connected to a simulated board."""
    return connected(watch, quick_simulator.url)


class Stranger:
    """A pseudo-terminal with another device behind it, or none."""

    def __init__(self, answer: Callable[[bytes], bytes]) -> None:
        self.master, self._slave = os.openpty()
        self.url = os.ttyname(self._slave)
        self._answer = answer
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self) -> None:
        import tty

        tty.setraw(self._slave)
        while (data := os.read(self.master, 256)) != b"\0quit":
            os.write(self.master, self._answer(data))

    def end(self) -> None:
        import termios

        termios.tcflush(self._slave, termios.TCIOFLUSH)
        os.write(self._slave, b"\0quit")
        self._thread.join(5)
        os.close(self.master)
        os.close(self._slave)


@pytest.fixture
def stranger() -> Iterator[Callable[[Callable[[bytes], bytes]], Stranger]]:
    strangers: list[Stranger] = []

    def make(answer: Callable[[bytes], bytes]) -> Stranger:
        strangers.append(Stranger(answer))
        return strangers[-1]

    yield make
    for one in strangers:
        one.end()


Make = Callable[[Callable[[bytes], bytes]], Stranger]


# --- Life -------------------------------------------------------------------------------


def test_board_reports_arrive_in_gui_thread(line: Watched) -> None:
    line.wait(Batch)
    (connected,) = [one for one in line.reports if isinstance(one, Connected)]
    assert str(connected.state.signature) == "TReX 1.2"
    assert line.threads == {threading.main_thread()}


def close(line: Watched) -> float:
    """Close a line; return how many seconds that took."""
    begun = time.monotonic()
    assert line.worker.close(15_000)
    took = time.monotonic() - begun
    assert line.worker.isFinished()
    line.wait(Closed)
    assert line.end == Closed(None)
    return took


def test_closing_ends_thread_within_a_second(
    quick_simulator: SimulatedDevice, watch: Watch
) -> None:
    assert is_soon(1.0, lambda: close(connected(watch, quick_simulator.url)))


def test_closed_port_can_be_opened_again(line: Watched, watch: Watch) -> None:
    assert line.worker.close(15_000)
    again = connected(watch, line.url)
    assert again.has(Connected)


def test_closing_during_connect_ends_within_a_second(
    quick_simulator: SimulatedDevice, watch: Watch
) -> None:
    def take() -> float:
        watched = watch(quick_simulator.url)
        watched.worker.start()
        return close(watched)

    assert is_soon(1.0, take)


def test_unstarted_worker_can_be_closed(watch: Watch) -> None:
    assert watch("/dev/nothing").worker.close()


def test_closing_brakes_running_motor(line: Watched, quick_simulator: SimulatedDevice) -> None:
    line.worker.submit(SetDrive(1, Drive.at(100)))
    line.qtbot.waitUntil(lambda: quick_simulator.show()["motors"][0]["speed"] == 100)
    assert line.worker.close(15_000)

    def motor() -> tuple[str, int]:
        shown = quick_simulator.show()["motors"][0]
        return shown["direction"], shown["speed"]

    line.qtbot.waitUntil(lambda: motor() == ("brake", 127))


# --- Requests ---------------------------------------------------------------------------


def test_each_request_gets_its_outcome(line: Watched) -> None:
    line.worker.submit(Ask(1, GetParameter(0)))
    line.worker.submit(Write(2, (("serial_timeout", 9),)))
    line.worker.submit(Ask(3, GetParameter(7)))
    line.worker.submit(Stop(4))
    assert line.outcome(1).value == 7
    assert line.outcome(2).error is None
    assert line.outcome(3).value == 9
    assert line.outcome(4).error is None


def test_requests_are_accepted_from_any_thread(line: Watched) -> None:
    threads = [
        threading.Thread(target=line.worker.submit, args=(Ask(number, GetParameter(0)),))
        for number in range(20)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {line.outcome(number).value for number in range(20)} == {7}


def test_batches_are_limited_to_60_a_second(line: Watched) -> None:
    """Compare sample times, since the window may receive batches late."""
    line.reports.clear()

    def ends() -> list[float]:
        return [one.samples[-1].time for one in line.reports if isinstance(one, Batch)]

    line.qtbot.waitUntil(lambda: len(ends()) >= 30)
    assert ends()[29] - ends()[0] > 29 / 60 - 0.1


# --- Trouble ----------------------------------------------------------------------------


def test_unplugged_cable_ends_session_within_half_a_second(
    quick_simulator: SimulatedDevice, watch: Watch
) -> None:
    def take() -> float:
        line = connected(watch, url[-1])
        quick_simulator.do("line unplug")
        begun = time.monotonic()
        line.wait(Closed)
        took = time.monotonic() - begun
        assert isinstance(line.end.error, PortUnavailable)
        assert "Plug it in, then connect again" in str(line.end.error)
        assert line.worker.wait(15_000)
        url.append(quick_simulator.do("line plug").split()[-1])
        return took

    url = [quick_simulator.url]
    assert is_soon(0.5, take)


def test_ended_simulator_is_reported_as_unavailable_port(
    line: Watched, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.end()
    line.wait(Closed)
    assert isinstance(line.end.error, PortUnavailable)


def test_missing_port_is_reported(watch: Watch) -> None:
    watched = watch("/dev/ttyNothing9")
    watched.worker.start()
    watched.wait(Closed)
    assert "There is no port /dev/ttyNothing9" in str(watched.end.error)


def test_port_in_use_is_reported(line: Watched, watch: Watch) -> None:
    watched = watch(line.url)
    watched.worker.start()
    watched.wait(Closed)
    assert "is in use" in str(watched.end.error)
    assert not line.has(Closed)


def test_silent_device_is_reported_as_no_reply(stranger: Make, watch: Watch) -> None:
    url = stranger(lambda _data: b"").url

    def take() -> float:
        watched = watch(url)
        begun = time.monotonic()
        watched.worker.start()
        watched.wait(Closed)
        took = time.monotonic() - begun
        assert isinstance(watched.end.error, NoReply)
        assert "No TReX answers" in str(watched.end.error)
        assert watched.worker.wait(15_000)
        return took

    assert is_soon(1.5, take)


def test_other_device_is_reported_as_bad_reply(stranger: Make, watch: Watch) -> None:
    watched = watch(stranger(lambda _data: b"ERROR: unknown command\r\n").url)
    watched.worker.start()
    watched.wait(Closed)
    assert isinstance(watched.end.error, BadReply)
    assert "not as a TReX does" in str(watched.end.error)


def test_loopback_plug_is_reported_as_joined_wires(stranger: Make, watch: Watch) -> None:
    watched = watch(stranger(lambda data: data).url)
    watched.worker.start()
    watched.wait(Closed)
    assert isinstance(watched.end.error, NoReply)
    assert "TX and RX are joined" in str(watched.end.error)
