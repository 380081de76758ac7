"""Line worker in virtual time and in a real thread."""

import sys
import threading
from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.session.helpers import packet
from tests.support.patient import PATIENT, PatientQtBot
from tests.support.simulator import SimulatedDevice
from trex_gui.core.session import Closed, Outcome, Progress
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.requests import SetMotor
from trex_gui.devices.trex.protocol.commands import GetParameter
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.session.messages import Batch, Connected, Report
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.ui.runtime import now, open_transport
from trex_gui.ui.workers.session_thread import LineWorker

if sys.platform == "win32":
    pytest.skip("Windows has no pseudo-terminals", allow_module_level=True)


class WorkerHarness:
    """Worker with its reports."""

    def __init__(self, url: str, qtbot: QtBot) -> None:
        self.reports: list[Report] = []
        self.threads: set[threading.Thread] = set()
        self.url = url
        timeouts = PATIENT if isinstance(qtbot, PatientQtBot) else Timeouts()
        settings = ConnectionSettings(url, timeouts=timeouts)
        self.worker = LineWorker(
            lambda inbox, notify: TrexSession(settings, inbox, notify, open_transport)
        )
        self.worker.reported.connect(self._on_reported)
        self.qtbot = qtbot

    def _on_reported(self, report: Report) -> None:
        self.threads.add(threading.current_thread())
        self.reports.append(report)

    def has(self, kind: type) -> bool:
        return any(isinstance(report, kind) for report in self.reports)

    def wait(self, kind: type) -> None:
        self.qtbot.waitUntil(lambda: self.has(kind))

    def close(self) -> float:
        """Close the line. Return the seconds until its thread ended."""
        start = now()
        assert self.worker.close(15_000)
        duration = now() - start
        self.wait(Closed)
        assert self.end == Closed(None)
        return duration

    def outcome(self, number: int) -> Outcome:
        """Wait for the outcome of a request."""

        def outcomes() -> list[Outcome]:
            reports = [report for report in self.reports if isinstance(report, Outcome)]
            return [report for report in reports if report.id == number]

        self.qtbot.waitUntil(lambda: bool(outcomes()))
        (outcome,) = outcomes()
        return outcome

    @property
    def end(self) -> Closed:
        """Return the last report."""
        closed = self.reports[-1]
        assert isinstance(closed, Closed)
        return closed


CreateWorker = Callable[[str], WorkerHarness]


@pytest.fixture
def create_worker(qtbot: QtBot) -> Iterator[CreateWorker]:
    """Yield a function that creates workers. All workers must end after the test."""
    created: list[WorkerHarness] = []

    def create(url: str) -> WorkerHarness:
        created.append(WorkerHarness(url, qtbot))
        return created[-1]

    yield create
    for harness in created:
        assert harness.worker.close(15_000), "the thread still runs"


def connected(create_worker: CreateWorker, url: str) -> WorkerHarness:
    """Return a worker that is connected to a simulated board."""
    harness = create_worker(url)
    harness.worker.start()
    harness.qtbot.waitUntil(lambda: harness.has(Connected) or harness.has(Closed))
    assert harness.has(Connected), harness.end
    return harness


@pytest.fixture
def line(quick_simulator: SimulatedDevice, create_worker: CreateWorker) -> WorkerHarness:
    """Worker on a simulated board without transmission time."""
    return connected(create_worker, quick_simulator.url)


@pytest.fixture
def paced_line(simulator: SimulatedDevice, create_worker: CreateWorker) -> WorkerHarness:
    """Worker on a simulated board with real transmission time."""
    return connected(create_worker, simulator.url)


@pytest.mark.realtime
def test_reports_reach_gui_thread_and_any_thread_sends_requests(line: WorkerHarness) -> None:
    line.wait(Batch)
    (connected,) = [report for report in line.reports if isinstance(report, Connected)]
    assert str(connected.state.signature) == "TReX 1.2"
    threads = [
        threading.Thread(target=line.worker.submit, args=(packet(number, GetParameter(0)),))
        for number in range(20)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {line.outcome(number).value for number in range(20)} == {b"\x07"}
    assert line.threads == {threading.main_thread()}


def test_closing_during_connect_ends_within_a_second(
    simulator: SimulatedDevice, create_worker: CreateWorker
) -> None:
    harness = create_worker(simulator.url)
    harness.worker.start()
    harness.wait(Progress)
    assert harness.close() < 1.0
    assert not harness.has(Connected)


@pytest.mark.realtime
def test_closing_immediately_after_start_ends_the_thread(
    quick_simulator: SimulatedDevice, create_worker: CreateWorker
) -> None:
    harness = create_worker(quick_simulator.url)
    harness.worker.start()
    harness.close()
    assert harness.worker.isFinished()


def test_closing_brakes_running_motor(
    paced_line: WorkerHarness, simulator: SimulatedDevice
) -> None:
    def motor() -> tuple[str, int]:
        shown = simulator.show()["motors"][0]
        return shown["direction"], shown["speed"]

    paced_line.worker.submit(SetMotor(1, Drive.at(100)))
    paced_line.qtbot.waitUntil(lambda: motor() == ("forward", 100))
    assert paced_line.close() < 1.0
    assert motor() == ("brake", 127)
