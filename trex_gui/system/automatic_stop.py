"""Automatic stop from any thread, and its causes on every system: internal errors, suspend."""

import sys
import threading
import time
from collections.abc import Callable
from types import TracebackType
from typing import Any

from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer, Signal, Slot

_INTERVAL_MS = 500
_LEAST_S = 1.0
"""Seconds of sleep that count; less is the rounding of two clocks that are read one by one."""


class StopBroadcaster(QObject):
    """Sends a stop without the GUI thread, which may be busy, hung or dead.

    `stop_now` must be safe in any thread. An internal error in a slot of `stopped` causes a stop,
    too: it is sent, but not reported again.

    Signals:
        stopped: the reason; later, from the event loop of the thread that this lives in.
    """

    stopped = Signal(str)
    _sent = Signal(str)

    def __init__(self, stop_now: Callable[[], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stop_now = stop_now
        self._reporting: int | None = None  # thread
        self._sent.connect(self._report, Qt.ConnectionType.QueuedConnection)

    def stop(self, reason: str) -> None:
        """Stop every device; may be called from any thread."""
        self._stop_now()
        if self._reporting != threading.get_ident():
            self._sent.emit(reason)

    @Slot(str)
    def _report(self, reason: str) -> None:
        self._reporting = threading.get_ident()
        try:
            self.stopped.emit(reason)
        finally:
            self._reporting = None


class ExceptionWatch:
    """Calls `stop` for every uncaught exception, in slots of Qt too, before Python's hooks.

    The program goes on if it can: a window that still responds is of more use beside a robot than
    none. `stop` is called in the thread of the error with a clause without a full stop.
    """

    def __init__(self, stop: Callable[[str], None]) -> None:
        self._stop = stop
        self._before = sys.excepthook, threading.excepthook, sys.unraisablehook
        sys.excepthook = self._on_exception
        threading.excepthook = self._on_thread_exception
        sys.unraisablehook = self._on_unraisable

    def close(self) -> None:
        """Put the hooks back."""
        sys.excepthook, threading.excepthook, sys.unraisablehook = self._before

    def _on_exception(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        try:
            self._stop(_reason(error))
        finally:
            self._before[0](kind, error, trace)

    def _on_thread_exception(self, args: threading.ExceptHookArgs) -> None:
        try:
            self._stop(_reason(args.exc_value))
        finally:
            self._before[1](args)

    def _on_unraisable(self, args: Any) -> None:  # its type has no name at run time
        try:
            self._stop(_reason(args.exc_value))
        finally:
            self._before[2](args)


def _reason(error: BaseException | None) -> str:
    text = QCoreApplication.translate("ExceptionWatch", "Internal error ({0})")
    return text.format(type(error).__name__)


def slept_so_far() -> float:
    """Return seconds that this computer has slept since it was started, if the system reports it.

    Linux has a clock that stands still meanwhile and one that does not. Elsewhere 0. On Windows
    Python's monotonic clock goes on, so that the line session misses its signs of life. On macOS
    it stands still during sleep, as everything that is measured with it: sleep is not seen there.
    """
    boottime = getattr(time, "CLOCK_BOOTTIME", None)
    return time.clock_gettime(boottime) - time.monotonic() if boottime is not None else 0.0


class SuspendDetector(QObject):
    """Checks twice a second whether the computer was suspended.

    Signals:
        woke: it was; the reason to stop, a clause without a full stop.
    """

    woke = Signal(str)

    def __init__(
        self, slept: Callable[[], float] = slept_so_far, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._slept = slept
        self._known = slept()
        self._timer = QTimer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self.look)
        self._timer.start()

    @Slot()
    def look(self) -> None:
        """Compare the clocks."""
        before, self._known = self._known, self._slept()
        if self._known - before >= _LEAST_S:
            self.woke.emit(self.tr("The computer was asleep"))
