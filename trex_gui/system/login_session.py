"""Screen lock, sleep and shutdown of Linux desktops, over D-Bus.

Ref: org.freedesktop.login1 (systemd), org.freedesktop.ScreenSaver (KDE, Xfce and others),
org.gnome.ScreenSaver. org.freedesktop.login1.Manager, Inhibit: "delay" delays sleep until the
returned descriptor is closed, but not longer than InhibitDelayMaxSec (by default 5 s).
"""

import logging
import os
from collections.abc import Callable

from PySide6.QtCore import SLOT, QObject, Signal, Slot
from PySide6.QtDBus import (
    QDBusConnection,
    QDBusMessage,
    QDBusPendingCallWatcher,
    QDBusUnixFileDescriptor,
)

from trex_gui.core.translation import tr
from trex_gui.system.stop_wait import StopWait

log = logging.getLogger(__name__)

_LOGIN = "org.freedesktop.login1"
_PATH = "/org/freedesktop/login1"
_ANY = ""
"""Any service or path. The bus configuration decides which programs may send these signals. An
unnecessary stop does no harm."""


class SessionEvents(QObject):
    leaving = Signal(str)  # why the user can no longer see the window, a clause without a period
    sleeping = Signal(bool)  # True before sleep (after `leaving`), False after sleep

    def __init__(
        self,
        system: QDBusConnection | None = None,
        session: QDBusConnection | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        system = system or QDBusConnection.systemBus()
        session = session or QDBusConnection.sessionBus()
        if system.isConnected():
            self._listen(system, f"{_LOGIN}.Manager", "PrepareForSleep", "_on_sleep(bool)")
            self._listen(system, f"{_LOGIN}.Manager", "PrepareForShutdown", "_on_shut_down(bool)")
            self._listen(system, f"{_LOGIN}.Session", "Lock", "_on_locked()")
        if session.isConnected():
            for interface in ("org.freedesktop.ScreenSaver", "org.gnome.ScreenSaver"):
                self._listen(session, interface, "ActiveChanged", "_on_saver(bool)")

    def _listen(self, bus: QDBusConnection, interface: str, name: str, slot: str) -> None:
        # The stub requires bytes, but the binding accepts the str that SLOT returns.
        if not bus.connect(_ANY, _ANY, interface, name, self, SLOT(slot)):  # type: ignore[call-overload]
            log.info("cannot subscribe to %s.%s", interface, name)

    @Slot(bool)
    def _on_sleep(self, is_starting: bool) -> None:
        if is_starting:
            self.leaving.emit(tr("The computer is going to sleep"))
        self.sleeping.emit(is_starting)

    @Slot(bool)
    def _on_shut_down(self, is_starting: bool) -> None:
        if is_starting:
            self.leaving.emit(tr("The computer is shutting down"))

    @Slot()
    def _on_locked(self) -> None:
        self.leaving.emit(tr("The screen was locked"))

    @Slot(bool)
    def _on_saver(self, active: bool) -> None:
        if active:
            self._on_locked()


class SleepDelay(QObject):
    """Delays sleep until the stop of the motors is confirmed.

    Without logind, sleep is not delayed.

    Args:
        may_move: returns True if motors were driven and no stop has been confirmed since.
        timeout: maximum delay in seconds.
    """

    def __init__(
        self,
        may_move: Callable[[], bool],
        system: QDBusConnection | None = None,
        parent: QObject | None = None,
        *,
        timeout: float,
    ) -> None:
        super().__init__(parent)
        self._bus = system or QDBusConnection.systemBus()
        self._descriptor: int | None = None
        self._request: QDBusPendingCallWatcher | None = None
        self._wait = StopWait(may_move, self.release, self, timeout=timeout)
        self.request()

    @property
    def is_active(self) -> bool:
        """True if the computer will wait for this program before sleeping."""
        return self._descriptor is not None

    def request(self) -> None:
        """Request a delay of the next sleep. Does not wait for the reply."""
        if self.is_active or self._request is not None or not self._bus.isConnected():
            return
        call = QDBusMessage.createMethodCall(_LOGIN, _PATH, f"{_LOGIN}.Manager", "Inhibit")
        why = tr("Stopping the motors before the computer sleeps")
        call.setArguments(["sleep", "TReX Studio", why, "delay"])
        call.setAutoStartService(False)
        self._request = QDBusPendingCallWatcher(self._bus.asyncCall(call), self)
        self._request.finished.connect(self._on_reply)

    def release(self) -> None:
        self._wait.cancel()
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    @Slot(bool)
    def on_sleeping(self, is_starting: bool) -> None:
        """Allow sleep once the stop is confirmed. After sleep, request a new delay."""
        if is_starting:
            self._wait.start()
        else:
            self._wait.cancel()
            self.request()

    @Slot(QDBusPendingCallWatcher)
    def _on_reply(self, watcher: QDBusPendingCallWatcher) -> None:
        self._request = None
        watcher.deleteLater()
        reply = watcher.reply()
        values = reply.arguments()
        if not values or not isinstance(values[0], QDBusUnixFileDescriptor):
            log.info("sleep cannot be delayed: %s", reply.errorMessage())
            return
        # Duplicated, because Qt closes the descriptor of the message.
        self._descriptor = os.dup(values[0].fileDescriptor())
