"""Supervisor that stops every device on a signal, internal error, suspend or screen lock."""

import atexit
import logging
import math
import os
import sys
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal, Slot

from trex_gui.core.translation import tr
from trex_gui.core.transport.driven import driven_boards, left_running_text
from trex_gui.system.signals import SignalWatch
from trex_gui.ui.notifier import Remedy
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import now

if TYPE_CHECKING:
    from trex_gui.system.login_session import SleepDelay

log = logging.getLogger(__name__)

UNCONFIRMED_STOP = 1  # exit code if motors may still turn
INTERNAL_ERROR = 1  # exit code if the interpreter ends while the event loop runs

_REPEAT_S = 1.0  # seconds within which a recurring error may be caused by its own report

_POLL_INTERVAL_MS = 500
_MIN_SLEEP_S = 1.0  # seconds; the two clocks are not read at the same time, so they differ slightly


class SafetySupervisor(QObject):
    """Stops every device when an event outside the window requires it.

    Create the supervisor in the main thread. Each device reports the effect of a stop.
    """

    def __init__(
        self,
        program: Program,
        parent: QObject | None = None,
        *,
        end_log: Callable[[], object] = lambda: None,
    ) -> None:
        """`end_log`: writes the remaining log entries before the process exits at once."""
        super().__init__(parent)
        self._program = program
        self._end_log = end_log
        stop_now = program.device_manager.stop_now
        self._stopper = StopBroadcaster(stop_now, self)
        self._error_stopper = StopBroadcaster(stop_now, self)
        self._error = ""
        self._error_at = -math.inf
        suspended = tr("The program was suspended (Ctrl-Z)")
        self._signals = SignalWatch(
            lambda: stop_now(ending=True), lambda: self._stopper.stop(suspended), self
        )
        self._exceptions = ExceptionWatch(self._error_stopper.stop)
        self._suspend_detector = SuspendDetector(parent=self)
        self._sleep_delay: SleepDelay | None = None
        self._session = self._session_events()

        atexit.register(self._on_exit)
        self._stopper.stopped.connect(program.device_manager.stop_because)
        self._error_stopper.stopped.connect(self._on_error)
        self._signals.caught.connect(self._on_signal)
        self._suspend_detector.woke.connect(self._stopper.stop)

    def _session_events(self) -> QObject | None:
        if sys.platform == "win32":
            from trex_gui.system.windows_events import WindowsEvents  # noqa: PLC0415 - only Windows

            windows = WindowsEvents(self)
            windows.watch_session_of(int(self._program.window.winId()))
            windows.leaving.connect(self._stopper.stop)
            return windows
        manager, limit = self._program.device_manager, self._program.timeouts.sleep_delay
        if sys.platform == "darwin":
            from trex_gui.system import mac_events  # noqa: PLC0415 - only macOS

            try:
                native = mac_events.NativeMac()
            except (OSError, AttributeError, ValueError) as error:  # a library or symbol is missing
                log.warning("screen lock and sleep cannot be detected: %s", error)
                return None
            mac = mac_events.MacEvents(native, lambda: manager.may_move, self, timeout=limit)
            mac.leaving.connect(self._stopper.stop)
            return mac
        try:
            from trex_gui.system import login_session  # noqa: PLC0415 - needs D-Bus
        except ImportError as error:  # the D-Bus library is missing
            log.info("screen lock cannot be detected: %s", error)
            return None
        events = login_session.SessionEvents(parent=self)
        events.leaving.connect(self._stopper.stop)
        self._sleep_delay = login_session.SleepDelay(
            lambda: manager.may_move, parent=self, timeout=limit
        )
        events.sleeping.connect(self._sleep_delay.on_sleeping)
        return events

    def close(self) -> None:
        """Stop watching. Call this after the line is closed."""
        atexit.unregister(self._on_exit)
        if self._sleep_delay is not None:
            self._sleep_delay.release()
        self._exceptions.close()
        self._signals.close()

    def report_unconfirmed_stop(self) -> bool:
        """Print a warning if a stop is unconfirmed. Return whether a motor may be turning.

        The window may no longer be open to show the warning. Call this after the line is closed.
        """
        left = "\n".join(left_running_text(*board) for board in driven_boards().items())
        text = self._program.device_manager.unconfirmed_stop or left
        if text and sys.stderr is not None:  # `None` without a console on Windows
            sys.stderr.write(f"{text}\n")
            sys.stderr.flush()
        return bool(text)

    def _on_exit(self) -> None:
        """Stop the motors and exit after `sys.exit` in a slot or event handler.

        PySide ends the interpreter at once, and its exit code is not known here. Without this
        handler, the running thread of the line would be destroyed. Qt would then abort while the
        motors turn.
        """
        log.error("the interpreter ends while the window is open")
        try:
            self._program.shut_down()
            self.report_unconfirmed_stop()
            self._end_log()
        finally:
            os._exit(INTERNAL_ERROR)

    @Slot(str)
    def _on_error(self, reason: str) -> None:
        """Report an internal error, even if no motor had to be stopped.

        An error that its own report causes would recur forever. A repeated error is therefore
        reported only if motors have been armed in the meantime. The stop has already been sent.
        """
        manager = self._program.device_manager
        is_repeated = reason == self._error and now() - self._error_at < _REPEAT_S
        self._error = reason
        self._error_at = now()
        if not is_repeated or manager.is_armed:
            manager.stop_because(reason, (Remedy.REPORT,))

    @Slot(int)
    def _on_signal(self, number: int) -> None:
        log.info("ended by signal %d", number)
        self._program.end()


class StopBroadcaster(QObject):
    """Sends a stop without the GUI thread, which may be busy, hung or dead.

    `stop_now` must be safe to call from any thread. An internal error in a slot of `stopped` also
    sends a stop, but does not emit `stopped` again.
    """

    stopped = Signal(str)  # the reason, emitted from the event loop of this object's thread
    _sent = Signal(str)

    def __init__(self, stop_now: Callable[[], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stop_now = stop_now
        self._reporting: int | None = None  # thread that emits `stopped`
        self._sent.connect(self._report, Qt.ConnectionType.QueuedConnection)

    def stop(self, reason: str) -> None:
        """Stop every device. May be called from any thread."""
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
    """Calls `stop` for every uncaught exception, including exceptions in Qt slots.

    The program continues if it can, because the user needs the window to stop a robot. `stop` is
    called in the thread of the exception. Its argument is a clause without a period.
    """

    def __init__(self, stop: Callable[[str], None]) -> None:
        self._stop = stop
        self._previous = sys.excepthook, threading.excepthook, sys.unraisablehook
        sys.excepthook = self._hook(sys.excepthook, lambda _kind, error, _trace: error)
        threading.excepthook = self._hook(threading.excepthook, lambda args: args.exc_value)
        sys.unraisablehook = self._hook(sys.unraisablehook, lambda args: args.exc_value)

    def close(self) -> None:
        sys.excepthook, threading.excepthook, sys.unraisablehook = self._previous

    def _hook(
        self, previous: Callable[..., Any], error_of: Callable[..., BaseException | None]
    ) -> Callable[..., None]:
        def hook(*args: Any) -> None:
            error = error_of(*args)
            try:
                text = tr("Internal error ({0})")
                self._stop(text.format(type(error).__name__))
            finally:
                # The previous hook prints the error.
                log.critical("uncaught exception", exc_info=error, extra={"printed": True})
                previous(*args)

        return hook


def slept_so_far() -> float:
    """Return the seconds for which this computer has slept since it started. 0 if unknown.

    Only Linux has `CLOCK_BOOTTIME`, which continues during sleep. Elsewhere `WindowsEvents` and
    `MacEvents` announce sleep. On Windows the monotonic clock continues, too, so the line session
    detects missed heartbeats.
    """
    boottime = getattr(time, "CLOCK_BOOTTIME", None)
    return time.clock_gettime(boottime) - time.monotonic() if boottime is not None else 0.0


class SuspendDetector(QObject):
    """Polls the clocks to detect that the computer was suspended."""

    woke = Signal(str)  # reason to stop, a clause without a period

    def __init__(
        self, slept: Callable[[], float] = slept_so_far, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._slept = slept
        self._last_slept = slept()
        self._timer = QTimer(self)
        self._timer.setInterval(_POLL_INTERVAL_MS)
        self._timer.timeout.connect(self.poll)
        self._timer.start()

    @Slot()
    def poll(self) -> None:
        before, self._last_slept = self._last_slept, self._slept()
        if self._last_slept - before >= _MIN_SLEEP_S:
            self.woke.emit(tr("The computer was asleep"))
