"""A locked screen and a computer that goes to sleep, as Linux desktops tell it over D-Bus.

Ref: org.freedesktop.login1 (systemd), org.freedesktop.ScreenSaver (KDE, Xfce and others),
org.gnome.ScreenSaver.
"""

import logging

from PySide6.QtCore import SLOT, QObject, Signal, Slot
from PySide6.QtDBus import QDBusConnection

log = logging.getLogger(__name__)

_LOGIN = "org.freedesktop.login1"
_ANY = ""
"""Any service, or any path: who may say such things on a bus decides its configuration, and a
stop too many hurts nobody."""


class SessionEvents(QObject):
    """Listens on the buses that are there.

    Signals:
        leaving: nobody looks at the window any more, or soon; why to stop, for people: a clause
            without a full stop.
        sleeping: the computer is about to sleep (after `leaving`), or has woken up.
    """

    leaving = Signal(str)
    sleeping = Signal(bool)

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
        # The stub asks for bytes; the binding takes what SLOT makes, a str.
        if not bus.connect(_ANY, _ANY, interface, name, self, SLOT(slot)):  # type: ignore[call-overload]
            log.info("%s.%s cannot be listened to", interface, name)

    @Slot(bool)
    def _on_sleep(self, begins: bool) -> None:
        if begins:
            self.leaving.emit(self.tr("The computer goes to sleep"))
        self.sleeping.emit(begins)

    @Slot(bool)
    def _on_shut_down(self, begins: bool) -> None:
        if begins:
            self.leaving.emit(self.tr("The computer shuts down"))

    @Slot()
    def _on_locked(self) -> None:
        self.leaving.emit(self.tr("The screen was locked"))

    @Slot(bool)
    def _on_saver(self, active: bool) -> None:
        if active:
            self._on_locked()
