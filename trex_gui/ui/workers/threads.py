"""Worker threads, orphaned threads and garbage collection.

Qt aborts if a running thread is destroyed. If a thread does not end in time, its owner passes
it to `adopt_orphan`. While an orphan is running, the process must not exit normally.
"""

import gc

from PySide6.QtCore import QObject, QThread, QTimer, Slot

from trex_gui.ui.runtime import runtime

FOREVER = -1
_COLLECT_INTERVAL_MS = 1000


class WorkerThread(QThread):
    """Thread that the runtime starts.

    The object lives in the GUI thread. Only `run` executes in the new thread, so connect
    signals with `Qt.ConnectionType.QueuedConnection`.
    """

    def start(self, priority: QThread.Priority = QThread.Priority.InheritPriority) -> None:
        runtime().start(self, priority)

    def wait(self, milliseconds: int = FOREVER) -> bool:  # type: ignore[override]
        """Wait for the end of the thread. Return whether it ended in time.

        A `QDeadlineTimer` is not accepted, since it does not use the runtime's clock.
        """
        return runtime().wait(self, milliseconds)


_orphans: list[WorkerThread] = []


def adopt_orphan(thread: WorkerThread) -> None:
    """Retain a thread until it ends, independently of its owner.

    Call this in the thread in which the object lives.
    """
    thread.setParent(None)
    if thread not in _orphans:
        _orphans.append(thread)


def release_orphan(thread: WorkerThread) -> None:
    if thread in _orphans:
        _orphans.remove(thread)


def have_orphans_ended() -> bool:
    _orphans[:] = [thread for thread in _orphans if not thread.wait(0)]
    return not _orphans


class GuiThreadCollector(QObject):
    """Confines Python's garbage collector to the GUI thread.

    Python collects garbage in any thread, usually in the thread of a busy line. The process
    crashes if a widget is destroyed outside the GUI thread.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self)
        self._timer.setInterval(_COLLECT_INTERVAL_MS)
        self._timer.timeout.connect(self.collect)
        self._timer.start()

    def freeze(self) -> None:
        """Collect garbage, then exempt all existing objects from collection.

        A full collection of the program's 100,000 objects blocks the GUI thread for 50 ms.
        """
        gc.collect()
        gc.freeze()

    @Slot()
    def collect(self) -> None:
        counts = zip(gc.get_count(), gc.get_threshold(), strict=True)
        due = [generation for generation, (count, limit) in enumerate(counts) if count > limit]
        if due:
            gc.collect(max(due))
