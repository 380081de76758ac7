"""Threads that did not end when they were to."""

import threading

import pytest
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from trex_gui.ui.workers import orphaned_threads
from trex_gui.ui.workers.thread import WorkerThread

pytestmark = pytest.mark.realtime


class Held(WorkerThread):
    """Runs until it is let go."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.go = threading.Event()

    def run(self) -> None:
        self.go.wait(60)


def test_orphaned_thread_outlives_parent_until_finished(qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not orphaned_threads.any_running())  # of the tests before
    owner = QObject()
    thread = Held(owner)
    thread.start()
    orphaned_threads.adopt(thread)
    orphaned_threads.adopt(thread)
    go = thread.go
    del owner, thread
    assert orphaned_threads.any_running()
    assert not orphaned_threads.wait(1)
    go.set()
    assert orphaned_threads.wait(15_000)
    assert not orphaned_threads.any_running()


def test_orphaned_thread_can_be_released_once(qtbot: QtBot) -> None:
    thread = Held()
    thread.start()
    orphaned_threads.adopt(thread)
    thread.go.set()
    assert thread.wait(15_000)
    assert orphaned_threads.release(thread)
    assert not orphaned_threads.release(thread)
