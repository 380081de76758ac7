"""Threads that outlive their owner."""

import threading
import weakref

import pytest
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from trex_gui.ui.workers.threads import (
    WorkerThread,
    adopt_orphan,
    have_orphans_ended,
    release_orphan,
)

pytestmark = pytest.mark.realtime


class HeldThread(WorkerThread):
    """Thread that runs until `go` is set."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.go = threading.Event()

    def run(self) -> None:
        self.go.wait(60)


def test_orphaned_thread_outlives_parent_until_finished(qtbot: QtBot) -> None:
    qtbot.waitUntil(have_orphans_ended)  # of earlier tests
    owner = QObject()
    thread = HeldThread(owner)
    thread.start()
    adopt_orphan(thread)
    adopt_orphan(thread)
    go = thread.go
    del owner, thread
    assert not have_orphans_ended()
    go.set()
    qtbot.waitUntil(have_orphans_ended)


def test_orphaned_thread_can_be_released(qtbot: QtBot) -> None:
    thread = HeldThread()
    thread.start()
    adopt_orphan(thread)
    thread.go.set()
    assert thread.wait(15_000)
    release_orphan(thread)
    release_orphan(thread)
    kept = weakref.ref(thread)
    del thread
    assert kept() is None
