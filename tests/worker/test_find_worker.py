"""A search in a real thread on a real pseudo-terminal."""

import sys
import threading
import time

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.discovery import SEEK_TREX
from trex_gui.link.seekers import Step
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.protocol.errors import PortUnavailable
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.worker.find_worker import Errand, FindWorker, Searched

pytestmark = pytest.mark.realtime

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)


TRIES = 4
"""How often is tried what a computer that stands still for a moment spoils."""


class Watched:
    """A worker and everything that it told."""

    def __init__(self, *urls: str) -> None:
        self.steps: list[tuple[int, Step]] = []
        self.searched: list[Searched] = []
        self.threads: set[threading.Thread] = set()
        self.worker = FindWorker([Errand(LinkSettings(url), {"trex": SEEK_TREX}) for url in urls])
        self.worker.stepped.connect(self._on_stepped)
        self.worker.searched.connect(self._on_searched)

    @property
    def found(self) -> list[bool]:
        """Whether something was found, for each port."""
        return [bool(one.search.found) for one in self.searched]

    def _on_stepped(self, index: int, step: Step) -> None:
        self.threads.add(threading.current_thread())
        self.steps.append((index, step))

    def _on_searched(self, searched: Searched) -> None:
        self.searched.append(searched)


def search(qtbot: QtBot, *urls: str, found: list[bool]) -> Watched:
    """Search until something is found where it should be; return the last search."""
    for _ in range(TRIES):
        watched = Watched(*urls)
        with qtbot.waitSignal(watched.worker.finished, timeout=30_000):
            watched.worker.start()
        assert watched.worker.wait(15_000)
        if watched.found == found:
            break
    return watched


def test_scan_reports_ports_in_order_in_gui_thread(
    quick_simulator: SimulatedDevice,
    start_simulator: StartSimulator,
    qtbot: QtBot,
) -> None:
    other = start_simulator("--unpaced", "--model", "trexjr")
    urls = quick_simulator.url, "/dev/ttyNothing9", other.url
    watched = search(qtbot, *urls, found=[True, False, True])
    first, second, third = watched.searched
    assert first.search.found[0].name == "TReX 1.2"
    assert isinstance(second.search.error, PortUnavailable)
    assert third.search.found[0].name == "TReX Jr 1.2"
    assert {index for index, _ in watched.steps} == {0, 2}
    assert watched.threads == {threading.main_thread()}


def test_cancelled_scan_ends_within_a_second(
    quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    quick_simulator.do("power off")

    def take() -> float:
        watched = Watched(quick_simulator.url, quick_simulator.url)
        watched.worker.start()
        qtbot.waitUntil(lambda: len(watched.steps) >= 2)
        begun = time.monotonic()
        assert watched.worker.close(15_000)
        took = time.monotonic() - begun
        qtbot.waitUntil(lambda: bool(watched.searched))
        (searched,) = watched.searched
        assert searched.search.cancelled
        return took

    assert any(take() < 1.0 for _ in range(TRIES))
    quick_simulator.do("power on")


def test_scan_finds_board_at_other_baud_rate(
    quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    from trex_gui.link.client import Client
    from trex_gui.link.transport import SerialTransport
    from trex_gui.protocol.commands import SetParameter

    settings = LinkSettings(quick_simulator.url, timeouts=Timeouts(extra=5.0))
    client = Client(SerialTransport(settings), settings)
    client.request(SetParameter(0x7E, LineSettings(115200).to_wire()))
    client.close()
    quick_simulator.do("power cycle")
    watched = search(qtbot, quick_simulator.url, found=[True])
    (found,) = watched.searched[0].search.found
    assert found.settings.line.baud == 115200
