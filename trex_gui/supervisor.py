"""Stops every device when something outside the window requires it."""

import logging
import math
import sys
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot

from trex_gui.system.automatic_stop import ExceptionWatch, StopBroadcaster, SuspendDetector
from trex_gui.system.signals import SignalWatch
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import now

if TYPE_CHECKING:
    from trex_gui.system.login_session import SleepDelay

log = logging.getLogger(__name__)


_AGAIN_S = 1.0
"""Seconds within which the same internal error is caused by reporting the first."""


class SafetySupervisor(QObject):
    """Stops on signals, internal errors, suspend and a locked screen; create in the main thread.

    It knows the reason of a stop only; each device reports what the stop means.
    """

    def __init__(self, program: Program, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._program = program
        self._stopper = StopBroadcaster(program.stop_now, self)
        self._error_stopper = StopBroadcaster(program.stop_now, self)
        self._error = ""
        self._error_at = -math.inf
        suspended = self.tr("The program was suspended (Ctrl-Z)")
        self._signals = SignalWatch(
            lambda: program.stop_now(ending=True), lambda: self._stopper.stop(suspended), self
        )
        self._exceptions = ExceptionWatch(self._error_stopper.stop)
        self._wake = SuspendDetector(parent=self)
        self._sleep_delay: SleepDelay | None = None
        self._session = self._session_events()

        self._stopper.stopped.connect(self._on_stopped)
        self._error_stopper.stopped.connect(self._on_error)
        self._signals.caught.connect(self._on_signal)
        self._wake.woke.connect(self._stopper.stop)

    def _session_events(self) -> QObject | None:
        if sys.platform == "win32":
            from trex_gui.system.windows_events import WindowsEvents  # noqa: PLC0415 - only there

            windows = WindowsEvents(self)
            windows.watch_session_of(int(self._program.window.winId()))
            windows.leaving.connect(self._stopper.stop)
            return windows
        try:
            from trex_gui.system import login_session  # noqa: PLC0415 - needs D-Bus
        except ImportError as error:  # a system without the library of D-Bus
            log.info("a locked screen cannot be noticed: %s", error)
            return None
        events = login_session.SessionEvents(parent=self)
        events.leaving.connect(self._stopper.stop)
        manager = self._program.device_manager
        self._sleep_delay = login_session.SleepDelay(
            lambda: manager.may_move,
            parent=self,
            timeout=self._program.timeouts.sleep_delay,
        )
        events.sleeping.connect(self._sleep_delay.note_sleep)
        return events

    def close(self) -> None:
        """End: the line is closed."""
        if self._sleep_delay is not None:
            self._sleep_delay.give()
        self._exceptions.close()
        self._signals.close()

    @Slot(str)
    def _on_stopped(self, reason: str) -> None:
        self._program.device_manager.stop_because(reason)

    @Slot(str)
    def _on_error(self, reason: str) -> None:
        """Report an internal error even if there was nothing to stop.

        An error that is caused by the report itself comes again at once: it is not reported again,
        or that would never end. Its stop has been sent.
        """
        is_again = reason == self._error and now() - self._error_at < _AGAIN_S
        self._error = reason
        self._error_at = now()
        if not is_again:
            self._program.device_manager.stop_because(reason, is_news=True)

    @Slot(int)
    def _on_signal(self, _number: int) -> None:
        self._program.end()
