"""The base of every thread of the program."""

from PySide6.QtCore import QThread

from trex_gui.ui.runtime import runtime

FOREVER = -1


class WorkerThread(QThread):
    """A thread that starts and ends with the runtime.

    The object lives in the GUI thread; only `run` executes in the new one. Connect its signals with
    `Qt.ConnectionType.QueuedConnection`.
    """

    def start(self, priority: QThread.Priority = QThread.Priority.InheritPriority) -> None:
        runtime().start(self, priority)

    def wait(self, milliseconds: int = FOREVER) -> bool:  # type: ignore[override]
        """Return whether it has ended in time.

        Takes no `QDeadlineTimer`, unlike Qt's, which would be on a clock of its own.
        """
        return runtime().wait(self, milliseconds)
