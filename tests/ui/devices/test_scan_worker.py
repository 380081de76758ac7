"""A search in its thread: in virtual time, or in a real thread on a real pseudo-terminal."""

import sys
import threading

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.core.discovery.prober import ScanProgress
from trex_gui.core.discovery.scan import PortScan
from trex_gui.core.errors import PortUnavailable
from trex_gui.devices.trex.discovery import TREX_PROBER
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.scanner import ScanJob, ScanWorker
from trex_gui.ui.runtime import now

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)


class Watched:
    """A worker and everything that it told."""

    def __init__(self, *urls: str) -> None:
        self.steps: list[tuple[int, ScanProgress]] = []
        self.searched: list[tuple[int, PortScan]] = []
        self.threads: set[threading.Thread] = set()
        self.worker = ScanWorker(
            [ScanJob(ConnectionSettings(url), {"trex": TREX_PROBER}) for url in urls]
        )
        self.worker.stepped.connect(self._on_stepped)
        self.worker.searched.connect(self._on_searched)

    def _on_stepped(self, index: int, step: ScanProgress) -> None:
        self.threads.add(threading.current_thread())
        self.steps.append((index, step))

    def _on_searched(self, index: int, search: PortScan) -> None:
        self.threads.add(threading.current_thread())
        self.searched.append((index, search))


def search(qtbot: QtBot, *urls: str) -> Watched:
    """Search these ports to the end."""
    watched = Watched(*urls)
    with qtbot.waitSignal(watched.worker.finished):
        watched.worker.start()
    assert watched.worker.wait(15_000)
    return watched


def test_scan_reports_ports_in_order(
    quick_simulator: SimulatedDevice, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    other = start_simulator("--unpaced", "--model", "trexjr")
    watched = search(qtbot, quick_simulator.url, "/dev/ttyNothing9", other.url)
    first, second, third = [search for _, search in watched.searched]
    assert first.found[0].name == "TReX 1.2"
    assert isinstance(second.error, PortUnavailable)
    assert third.found[0].name == "TReX Jr 1.2"
    assert {index for index, _ in watched.steps} == {0, 2}


@pytest.mark.realtime
def test_scan_reports_arrive_in_gui_thread(quick_simulator: SimulatedDevice, qtbot: QtBot) -> None:
    watched = search(qtbot, quick_simulator.url, "/dev/ttyNothing9")
    assert watched.steps
    assert [index for index, _ in watched.searched] == [0, 1]
    assert watched.threads == {threading.main_thread()}


def test_cancelled_scan_ends_within_a_second(
    quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    quick_simulator.do("power off")
    watched = Watched(quick_simulator.url, quick_simulator.url)
    watched.worker.start()
    qtbot.waitUntil(lambda: len(watched.steps) >= 2)
    begun = now()
    assert watched.worker.close(15_000)
    assert now() - begun < 1.0
    ((_, search),) = watched.searched
    assert search.cancelled
