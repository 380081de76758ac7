"""Everything outside the window that has to stop what moves, put together in one place."""

import logging
import math
import sys
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot

from trex_gui.system.exceptions import ExceptionWatch
from trex_gui.system.signals import SignalWatch
from trex_gui.system.stopper import StopBroadcaster
from trex_gui.system.wake import SuspendDetector
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import now

if TYPE_CHECKING:
    from trex_gui.system.sleep_delay import SleepDelay

log = logging.getLogger(__name__)


_AGAIN_S = 1.0
"""Seconds within which a mistake that is told again comes of its being told."""


class SafetySupervisor(QObject):
    """Lives as long as the program's event loop; to be made in the main thread.

    Why everything is stopped is all that is known here: what it means is for each device to say.
    """

    def __init__(self, program: Program, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._program = program
        self._stopper = StopBroadcaster(program.stop_now, self)
        self._stopper_at_mistakes = StopBroadcaster(program.stop_now, self)
        self._mistake = ""
        self._mistake_at = -math.inf
        suspended = self.tr("The program was suspended (Ctrl-Z)")
        self._signals = SignalWatch(
            lambda: program.stop_now(ending=True), lambda: self._stopper.stop(suspended), self
        )
        self._exceptions = ExceptionWatch(self._stopper_at_mistakes.stop)
        self._wake = SuspendDetector(parent=self)
        self._sleep_delay: SleepDelay | None = None
        self._session = self._session_events()

        self._stopper.stopped.connect(self._on_stopped)
        self._stopper_at_mistakes.stopped.connect(self._on_mistake)
        self._signals.caught.connect(self._on_signal)
        self._wake.woke.connect(self._stopper.stop)

    def _session_events(self) -> QObject | None:
        if sys.platform == "win32":
            from trex_gui.system.windows_events import WindowsEvents  # noqa: PLC0415

            windows = WindowsEvents(self)
            windows.watch_session_of(int(self._program.window.winId()))
            windows.leaving.connect(self._stopper.stop)
            return windows
        try:
            from trex_gui.system.session_events import SessionEvents  # noqa: PLC0415
            from trex_gui.system.sleep_delay import SleepDelay  # noqa: PLC0415
        except ImportError as error:  # a system without the library of D-Bus
            log.info("nobody tells of a locked screen: %s", error)
            return None
        events = SessionEvents(parent=self)
        events.leaving.connect(self._stopper.stop)
        manager = self._program.device_manager
        self._sleep_delay = SleepDelay(
            lambda: manager.may_move,
            parent=self,
            patience=self._program.timeouts.sleep_delay,
        )
        events.sleeping.connect(self._sleep_delay.note_sleep)
        return events

    def close(self) -> None:
        """Watch no longer: the line is closed."""
        if self._sleep_delay is not None:
            self._sleep_delay.give()
        self._exceptions.close()
        self._signals.close()

    @Slot(str)
    def _on_stopped(self, reason: str) -> None:
        self._program.device_manager.stop_because(reason)

    @Slot(str)
    def _on_mistake(self, reason: str) -> None:
        """A person has to know of a mistake even where there was nothing to stop.

        One that comes of telling it comes again at once: it is not told again, or there was no end
        to it. Its stop has been sent.
        """
        is_again = reason == self._mistake and now() - self._mistake_at < _AGAIN_S
        self._mistake = reason
        self._mistake_at = now()
        if not is_again:
            self._program.device_manager.stop_because(reason, is_news=True)

    @Slot(int)
    def _on_signal(self, _number: int) -> None:
        self._program.end()
