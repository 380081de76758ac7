"""A stop from any thread: the motors first, the window afterwards."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal


class Stopper(QObject):
    """Sends a stop without asking the window's thread, which may be busy, hung or dead.

    `stop_now` must be safe in any thread.

    Signals:
        stopped: why, for people; in the thread of the receiver.
    """

    stopped = Signal(str)

    def __init__(self, stop_now: Callable[[], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stop_now = stop_now

    def stop(self, reason: str) -> None:
        """Stop every motor; may be called from any thread."""
        self._stop_now()
        self.stopped.emit(reason)
