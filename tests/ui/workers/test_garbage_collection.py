"""Garbage collection of Python in the GUI thread only."""

import gc
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.ui.workers.threads import GuiThreadCollector


class Cycle:
    """Object that only the garbage collector can free."""

    alive = 0

    def __init__(self) -> None:
        self.me = self
        Cycle.alive += 1

    def __del__(self) -> None:
        Cycle.alive -= 1


@pytest.fixture
def collector(qtbot: QtBot) -> Iterator[GuiThreadCollector]:
    yield GuiThreadCollector()
    gc.unfreeze()
    gc.collect()


def test_cycles_remain_until_collected_in_the_gui_thread(collector: GuiThreadCollector) -> None:
    assert not gc.isenabled()
    gc.collect()
    for _ in range(2000):
        Cycle()
    assert Cycle.alive == 2000
    collector.collect()
    assert Cycle.alive < 2000


def test_full_collection_ignores_frozen_objects(collector: GuiThreadCollector) -> None:
    collector.freeze()
    assert len(gc.get_objects()) < gc.get_freeze_count() / 10
    alive = Cycle.alive
    Cycle()
    gc.collect()
    assert Cycle.alive == alive
