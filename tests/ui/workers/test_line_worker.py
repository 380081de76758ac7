"""Line worker in a real thread."""

import sys
import threading
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.session.helpers import packet
from tests.support.patient import PATIENT
from tests.support.simulator import SimulatedDevice
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.trex.protocol.commands import GetParameter
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.messages import Batch, Connected, Report
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.ui.runtime import open_transport
from trex_gui.ui.workers.session_thread import LineWorker

if sys.platform == "win32":
    pytest.skip("Windows has no pseudo-terminals", allow_module_level=True)

pytestmark = pytest.mark.realtime


class WorkerHarness:
    """Worker with its reports."""

    def __init__(self, url: str) -> None:
        self.reports: list[Report] = []
        self.threads: set[threading.Thread] = set()
        settings = ConnectionSettings(url, timeouts=PATIENT)
        self.worker = LineWorker(
            lambda inbox, notify: TrexSession(settings, inbox, notify, open_transport)
        )
        self.worker.reported.connect(self._on_reported)

    def _on_reported(self, report: Report) -> None:
        self.threads.add(threading.current_thread())
        self.reports.append(report)

    def has(self, kind: type) -> bool:
        return any(isinstance(report, kind) for report in self.reports)


@pytest.fixture
def line(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[WorkerHarness]:
    """Started worker on a simulated board without transmission time."""
    del qtbot
    harness = WorkerHarness(quick_simulator.url)
    harness.worker.start()
    yield harness
    assert harness.worker.close(15_000), "the thread still runs"


def test_reports_reach_gui_thread_and_any_thread_sends_requests(
    line: WorkerHarness, qtbot: QtBot
) -> None:
    qtbot.waitUntil(lambda: line.has(Batch) or line.has(Closed))
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

    def outcomes() -> list[Outcome]:
        return [report for report in line.reports if isinstance(report, Outcome)]

    qtbot.waitUntil(lambda: len(outcomes()) >= 20)
    assert sorted(outcome.id for outcome in outcomes()) == [*range(20)]
    assert {outcome.value for outcome in outcomes()} == {b"\x07"}
    assert line.threads == {threading.main_thread()}


def test_closing_immediately_after_start_ends_the_thread(line: WorkerHarness, qtbot: QtBot) -> None:
    assert line.worker.close(15_000)
    assert line.worker.isFinished()
    qtbot.waitUntil(lambda: line.has(Closed))
    assert line.reports[-1] == Closed(None)
