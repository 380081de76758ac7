"""Screen lock, sleep and end of a session on Windows. Not tested on Windows yet.

Ref: Microsoft's documentation of WM_POWERBROADCAST, WM_WTSSESSION_CHANGE, WM_QUERYENDSESSION.
"""

import ctypes
import ctypes.wintypes
import sys

from PySide6.QtCore import QAbstractNativeEventFilter, QByteArray, QCoreApplication, QObject, Signal

from trex_gui.core.translation import tr

WM_QUERYENDSESSION, WM_POWERBROADCAST, WM_WTSSESSION_CHANGE = 0x0011, 0x0218, 0x02B1
PBT_APMSUSPEND = 0x0004
WTS_CONSOLE_DISCONNECT, WTS_REMOTE_DISCONNECT, WTS_SESSION_LOGOFF, WTS_SESSION_LOCK = 2, 4, 6, 7
_LOCKED = {WTS_CONSOLE_DISCONNECT, WTS_REMOTE_DISCONNECT, WTS_SESSION_LOGOFF, WTS_SESSION_LOCK}


def stop_reason(message: int, parameter: int) -> str | None:
    """Return the reason to stop the motors, or `None` if the message requires no stop."""
    if message == WM_POWERBROADCAST and parameter == PBT_APMSUSPEND:
        return tr("The computer is going to sleep")
    if message == WM_WTSSESSION_CHANGE and parameter in _LOCKED:
        return tr("The screen was locked")
    if message == WM_QUERYENDSESSION:
        return tr("The session is ending")
    return None


class _Filter(QAbstractNativeEventFilter):
    def __init__(self, owner: "WindowsEvents") -> None:
        super().__init__()
        self._owner = owner

    def nativeEventFilter(  # noqa: N802 - Qt's name
        self, kind: QByteArray | bytes | bytearray | memoryview, message: int
    ) -> object:
        if bytes(kind) == b"windows_generic_MSG":  # type: ignore[arg-type] # `bytes` accepts a QByteArray
            received = ctypes.wintypes.MSG.from_address(int(message))
            self._owner.handle(received.message, received.wParam)
        return False, 0


class WindowsEvents(QObject):
    leaving = Signal(str)  # why the user can no longer see the window, a clause without a period

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._filter = _Filter(self)
        if (app := QCoreApplication.instance()) is not None:
            app.installNativeEventFilter(self._filter)

    def watch_session_of(self, window: int) -> None:
        """Request messages about the session, such as a locked screen, for a native window."""
        if sys.platform == "win32":
            ctypes.windll.wtsapi32.WTSRegisterSessionNotification(window, 0)

    def handle(self, message: int, parameter: int) -> None:
        if reason := stop_reason(message, parameter):
            self.leaving.emit(reason)
