"""Threads that did not end when they were to."""

import threading

import pytest
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from trex_gui.worker import abandoned
from trex_gui.worker.thread import WorkerThread

pytestmark = pytest.mark.realtime


class Held(WorkerThread):
    """Runs until it is let go."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.go = threading.Event()

    def run(self) -> None:
        self.go.wait(60)


def test_orphaned_thread_outlives_parent_until_finished(qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not abandoned.any_running())  # of the tests before
    owner = QObject()
    thread = Held(owner)
    thread.start()
    abandoned.keep(thread)
    abandoned.keep(thread)
    go = thread.go
    del owner, thread
    assert abandoned.any_running()
    assert not abandoned.wait(1)
    go.set()
    assert abandoned.wait(15_000)
    assert not abandoned.any_running()


def test_orphaned_thread_can_be_released_once(qtbot: QtBot) -> None:
    thread = Held()
    thread.start()
    abandoned.keep(thread)
    thread.go.set()
    assert thread.wait(15_000)
    assert abandoned.forget(thread)
    assert not abandoned.forget(thread)
