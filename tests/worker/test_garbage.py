"""Python's collector works in the GUI thread only."""

import gc
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.worker.garbage import GuiThreadCollector


class Cycle:
    """Something that only the collector can free."""

    alive = 0

    def __init__(self) -> None:
        self.me = self
        Cycle.alive += 1

    def __del__(self) -> None:
        Cycle.alive -= 1


@pytest.fixture
def collector(qtbot: QtBot) -> Iterator[GuiThreadCollector]:
    yield GuiThreadCollector()
    gc.collect()


def test_cycles_stay_until_the_gui_thread_collects_them(collector: GuiThreadCollector) -> None:
    gc.collect()
    for _ in range(2000):
        Cycle()
    assert Cycle.alive == 2000
    collector.collect()
    assert Cycle.alive < 2000


def test_python_does_not_collect_by_itself_meanwhile(collector: GuiThreadCollector) -> None:
    assert not gc.isenabled()
