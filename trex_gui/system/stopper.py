"""A stop from any thread: the motors first, the window afterwards."""

import threading
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, Signal, Slot


class StopBroadcaster(QObject):
    """Sends a stop without asking the window's thread, which may be busy, hung or dead.

    `stop_now` must be safe in any thread. Whoever hears of a stop may make a mistake, and each
    mistake is a stop: one that happens while a stop is told is sent, but not told again.

    Signals:
        stopped: why, for people; later, from the event loop of the thread that this lives in.
    """

    stopped = Signal(str)
    _sent = Signal(str)

    def __init__(self, stop_now: Callable[[], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stop_now = stop_now
        self._telling: int | None = None  # the thread that does
        self._sent.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    def stop(self, reason: str) -> None:
        """Stop what can be stopped; may be called from any thread."""
        self._stop_now()
        if self._telling != threading.get_ident():
            self._sent.emit(reason)

    @Slot(str)
    def _tell(self, reason: str) -> None:
        self._telling = threading.get_ident()
        try:
            self.stopped.emit(reason)
        finally:
            self._telling = None
