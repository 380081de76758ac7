"""Worker threads: base class, threads that outlive their owner, and garbage collection.

Qt aborts when a running thread is destroyed. Therefore an owner passes a thread that does not end
in time to `adopt_orphan`. While such a thread is running, the process must not exit normally.
"""

import gc

from PySide6.QtCore import QObject, QThread, QTimer, Slot

from trex_gui.ui.runtime import runtime

FOREVER = -1
_COLLECT_INTERVAL_MS = 1000


class WorkerThread(QThread):
    """Thread that the runtime starts and waits for.

    The object lives in the GUI thread; only `run` executes in the new thread. Connect its signals
    with `Qt.ConnectionType.QueuedConnection`.
    """

    def start(self, priority: QThread.Priority = QThread.Priority.InheritPriority) -> None:
        runtime().start(self, priority)

    def wait(self, milliseconds: int = FOREVER) -> bool:  # type: ignore[override]
        """Wait for the end of the thread and return whether it ended in time.

        Unlike Qt's `wait`, it takes no `QDeadlineTimer`, which would run on another clock.
        """
        return runtime().wait(self, milliseconds)


_orphans: list[WorkerThread] = []


def adopt_orphan(thread: WorkerThread) -> None:
    """Retain a thread until it has ended. From now on its owner may be destroyed.

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
    """Runs Python's garbage collector only in the GUI thread, while this object exists.

    Python collects in whichever thread creates enough objects, usually the thread of a busy line. A
    widget that is destroyed outside the GUI thread crashes the process.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self)
        self._timer.setInterval(_COLLECT_INTERVAL_MS)
        self._timer.timeout.connect(self.collect)
        self._timer.start()

    def exempt_present(self) -> None:
        """Collect garbage. Exempt all objects that are left from later collections.

        The program's 100,000 objects would block the GUI thread for 50 ms at each full collection.
        """
        gc.collect()
        gc.freeze()

    @Slot()
    def collect(self) -> None:
        counts = zip(gc.get_count(), gc.get_threshold(), strict=True)
        due = [generation for generation, (count, limit) in enumerate(counts) if count > limit]
        if due:
            gc.collect(max(due))
