"""Threads that outlive their owners."""

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


class BlockedThread(WorkerThread):
    """Thread that runs until `released` is set."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.released = threading.Event()

    def run(self) -> None:
        self.released.wait(60)


def test_orphaned_thread_outlives_parent_until_finished(qtbot: QtBot) -> None:
    qtbot.waitUntil(have_orphans_ended)  # orphans of earlier tests
    owner = QObject()
    thread = BlockedThread(owner)
    thread.start()
    adopt_orphan(thread)
    adopt_orphan(thread)
    released = thread.released
    del owner, thread
    assert not have_orphans_ended()
    released.set()
    qtbot.waitUntil(have_orphans_ended)


def test_orphaned_thread_can_be_released(qtbot: QtBot) -> None:
    thread = BlockedThread()
    thread.start()
    adopt_orphan(thread)
    thread.released.set()
    assert thread.wait(15_000)
    release_orphan(thread)
    release_orphan(thread)
    reference = weakref.ref(thread)
    del thread
    assert reference() is None
