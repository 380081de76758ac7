"""A search in a real thread on a real pseudo-terminal."""

import sys
import threading
import time
from collections.abc import Callable

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatorProcess
from trex_gui.link.discovery import SEEK_TREX
from trex_gui.link.seekers import Step
from trex_gui.link.settings import LinkSettings
from trex_gui.protocol.errors import PortUnavailable
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.worker.find_worker import Errand, FindWorker, Searched

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)


class Watched:
    """A worker and everything that it told."""

    def __init__(self, *urls: str) -> None:
        self.steps: list[tuple[int, Step]] = []
        self.searched: list[Searched] = []
        self.threads: set[threading.Thread] = set()
        self.worker = FindWorker([Errand(LinkSettings(url), {"trex": SEEK_TREX}) for url in urls])
        self.worker.stepped.connect(self._on_stepped)
        self.worker.searched.connect(self._on_searched)

    def _on_stepped(self, index: int, step: Step) -> None:
        self.threads.add(threading.current_thread())
        self.steps.append((index, step))

    def _on_searched(self, searched: Searched) -> None:
        self.searched.append(searched)


def test_ports_are_searched_one_after_the_other(
    quick_simulator: SimulatorProcess,
    start_simulator: Callable[..., SimulatorProcess],
    qtbot: QtBot,
) -> None:
    other = start_simulator("--unpaced", "--model", "trexjr")
    watched = Watched(quick_simulator.url, "/dev/ttyNothing9", other.url)
    with qtbot.waitSignal(watched.worker.finished, timeout=15_000):
        watched.worker.start()
    first, second, third = watched.searched
    assert first.search.found[0].name == "TReX 1.2"
    assert isinstance(second.search.error, PortUnavailable)
    assert third.search.found[0].name == "TReX Jr 1.2"
    assert {index for index, _ in watched.steps} == {0, 2}
    assert watched.threads == {threading.main_thread()}


def test_a_search_ends_soon_when_it_is_cancelled(
    quick_simulator: SimulatorProcess, qtbot: QtBot
) -> None:
    quick_simulator.do("power off")
    watched = Watched(quick_simulator.url, quick_simulator.url)
    watched.worker.start()
    qtbot.waitUntil(lambda: len(watched.steps) >= 2)
    begun = time.monotonic()
    assert watched.worker.close()
    assert time.monotonic() - begun < 1.0
    qtbot.waitUntil(lambda: bool(watched.searched))
    (searched,) = watched.searched
    assert searched.search.cancelled
    quick_simulator.do("power on")


def test_a_board_at_other_settings_is_found(
    quick_simulator: SimulatorProcess, qtbot: QtBot
) -> None:
    from trex_gui.link.client import Client
    from trex_gui.link.transport import SerialTransport
    from trex_gui.protocol.commands import SetParameter

    settings = LinkSettings(quick_simulator.url)
    client = Client(SerialTransport(settings), settings)
    client.request(SetParameter(0x7E, LineSettings(115200).to_wire()))
    client.close()
    quick_simulator.do("power cycle")
    watched = Watched(quick_simulator.url)
    with qtbot.waitSignal(watched.worker.finished, timeout=15_000):
        watched.worker.start()
    (found,) = watched.searched[0].search.found
    assert found.settings.line.baud == 115200
