"""A moment for the motors before the computer sleeps, asked of systemd's logind over D-Bus.

Ref: org.freedesktop.login1.Manager, Inhibit: "delay" holds sleep up until the descriptor that was
given is closed, at most for InhibitDelayMaxSec (5 s unless set otherwise).
"""

import logging
import os
from collections.abc import Callable

from PySide6.QtCore import QObject, Slot
from PySide6.QtDBus import (
    QDBusConnection,
    QDBusMessage,
    QDBusPendingCallWatcher,
    QDBusUnixFileDescriptor,
)

from trex_gui.ui.runtime import runtime

log = logging.getLogger(__name__)

_LOGIN = "org.freedesktop.login1"
_PATH = "/org/freedesktop/login1"

_LOOK_MS = 20


class SleepDelay(QObject):
    """Holds sleep up while it is about to begin, until the motors are known to stand.

    Where nobody hands such things out, nothing is held up, and nothing fails.

    `may_move` says whether motors were driven and no stop was proved since.
    """

    def __init__(
        self,
        may_move: Callable[[], bool],
        system: QDBusConnection | None = None,
        parent: QObject | None = None,
        *,
        patience: float,
    ) -> None:
        """Wait for so many seconds; who closes a lid is not kept waiting longer."""
        super().__init__(parent)
        self._patience = patience
        self._may_move = may_move
        self._bus = system or QDBusConnection.systemBus()
        self._descriptor: int | None = None
        self._asked: QDBusPendingCallWatcher | None = None
        self._looked = 0
        self._timer = runtime().timer(self)
        self._timer.setInterval(_LOOK_MS)
        self._timer.timeout.connect(self._on_look)
        self.take()

    @property
    def holds(self) -> bool:
        """Whether sleep would wait for this program."""
        return self._descriptor is not None

    def take(self) -> None:
        """Ask for the next sleep to wait; the answer comes later."""
        if self.holds or self._asked is not None or not self._bus.isConnected():
            return
        call = QDBusMessage.createMethodCall(_LOGIN, _PATH, f"{_LOGIN}.Manager", "Inhibit")
        why = self.tr("Motors that can be stopped are stopped before the computer sleeps")
        call.setArguments(["sleep", "TReX Studio", why, "delay"])
        call.setAutoStartService(False)
        self._asked = QDBusPendingCallWatcher(self._bus.asyncCall(call), self)
        self._asked.finished.connect(self._on_answered)

    def give(self) -> None:
        """Hold nothing up any more."""
        self._timer.stop()
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    @Slot(bool)
    def note_sleep(self, begins: bool) -> None:
        """Let the computer sleep as soon as the motors stand; or, when it wakes, be ready again.

        The stop itself is somebody else's, and has gone out by now.
        """
        if begins:
            self._looked = 0
            self._timer.start()
        else:
            self._timer.stop()
            self.take()

    @Slot()
    def _on_look(self) -> None:
        self._looked += 1
        if not self._may_move() or self._looked * _LOOK_MS >= self._patience * 1000:
            self.give()

    @Slot(QDBusPendingCallWatcher)
    def _on_answered(self, watcher: QDBusPendingCallWatcher) -> None:
        self._asked = None
        watcher.deleteLater()
        answer = watcher.reply()
        values = answer.arguments()
        if not values or not isinstance(values[0], QDBusUnixFileDescriptor):
            log.info("sleep cannot be held up: %s", answer.errorMessage())
            return
        # Qt closes its own with the message.
        self._descriptor = os.dup(values[0].fileDescriptor())
