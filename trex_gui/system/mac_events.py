"""Screen lock, screen saver and sleep on macOS. Not tested on macOS yet.

Ref: Apple's documentation of CFNotificationCenter, and of IORegisterForSystemPower (IOKit,
IOPMLib.h, IOMessage.h): the system waits up to 30 s for `IOAllowPowerChange`. Apple does not
document the names of the login window's notifications, but many programs use them.
"""

import ctypes
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal

from trex_gui.core.translation import tr
from trex_gui.system.stop_wait import StopWait

CAN_SLEEP = 0xE0000270  # kIOMessageCanSystemSleep, sent when the computer is idle
WILL_SLEEP = 0xE0000280  # kIOMessageSystemWillSleep
LOCKED = ("com.apple.screenIsLocked", "com.apple.screensaver.didstart")

_FRAMEWORKS = "/System/Library/Frameworks/{0}.framework/{0}"
_UTF8 = 0x08000100
_DELIVER_IMMEDIATELY = 4  # CFNotificationSuspensionBehaviorDeliverImmediately

# Arguments: center, observer, name, object, user info.
_ON_NOTIFICATION = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5)

# Arguments: reference for the caller, service, message, argument of the message.
_ON_POWER = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_uint32, ctypes.c_void_p
)


class NativeMac:
    """Notifications of macOS, delivered in the window's thread.

    Args:
        load: loads a library.
        symbol: reads a constant from a library.

    Raises:
        OSError, AttributeError, ValueError: a library or a symbol is missing.
    """

    def __init__(
        self,
        load: Callable[[str], Any] = ctypes.CDLL,
        symbol: Callable[[Any, str], object] = ctypes.c_void_p.in_dll,
    ) -> None:
        core, power = (load(_FRAMEWORKS.format(name)) for name in ("CoreFoundation", "IOKit"))
        pointer, number, port = ctypes.c_void_p, ctypes.c_long, ctypes.c_uint32
        self._create_string = _typed(
            core.CFStringCreateWithCString, pointer, pointer, ctypes.c_char_p, ctypes.c_uint32
        )
        self._center = _typed(core.CFNotificationCenterGetDistributedCenter, pointer)
        self._observe = _typed(
            core.CFNotificationCenterAddObserver,
            None,
            *(pointer, pointer, _ON_NOTIFICATION, pointer, pointer, number),
        )
        self._main_loop = _typed(core.CFRunLoopGetMain, pointer)
        self._add_source = _typed(core.CFRunLoopAddSource, None, pointer, pointer, pointer)
        self._common_modes = symbol(core, "kCFRunLoopCommonModes")
        self._register = _typed(
            power.IORegisterForSystemPower,
            port,
            *(pointer, ctypes.POINTER(pointer), _ON_POWER, ctypes.POINTER(port)),
        )
        self._source_of = _typed(power.IONotificationPortGetRunLoopSource, pointer, pointer)
        self._allow = _typed(power.IOAllowPowerChange, ctypes.c_int, port, number)
        self._connection = 0
        self._referenced: tuple[object, ...] = ()  # macOS does not keep these objects alive

    def listen(
        self, on_locked: Callable[[], object], on_power: Callable[[int, int], object]
    ) -> None:
        """Start listening. `on_power` receives each power message and its argument."""
        notified = _ON_NOTIFICATION(lambda *_: on_locked())
        powered = _ON_POWER(
            lambda _own, _service, message, argument: on_power(message, argument or 0)
        )
        notification_port, notifier = ctypes.c_void_p(), ctypes.c_uint32()
        self._referenced = (notified, powered, notification_port, notifier)
        center = self._center()
        for observer, name in enumerate(LOCKED, start=1):  # 0 would mean no observer
            text = self._create_string(None, name.encode("ascii"), _UTF8)
            self._observe(center, observer, notified, text, None, _DELIVER_IMMEDIATELY)
        self._connection = self._register(
            None, ctypes.byref(notification_port), powered, ctypes.byref(notifier)
        )
        if self._connection:
            source = self._source_of(notification_port)
            self._add_source(self._main_loop(), source, self._common_modes)

    def allow_power_change(self, argument: int) -> None:
        """Allow a power change, identified by the argument of the message that announced it."""
        self._allow(self._connection, argument)


def _typed(function: Any, result: Any, *arguments: Any) -> Any:
    """Set the types of a C function. By default ctypes truncates pointers to 32 bits."""
    function.restype, function.argtypes = result, arguments
    return function


class MacEvents(QObject):
    """Reports events that require a stop. Allows sleep once the stop is confirmed."""

    leaving = Signal(str)  # why the user can no longer see the window, a clause without a period

    def __init__(
        self,
        native: NativeMac,
        may_move: Callable[[], bool],
        parent: QObject | None = None,
        *,
        timeout: float,
    ) -> None:
        """Sleep is delayed while `may_move` returns True, for at most `timeout` seconds."""
        super().__init__(parent)
        self._native = native
        self._sleep_argument = 0  # argument of the message that announces sleep
        self._wait = StopWait(may_move, self._allow, self, timeout=timeout)
        native.listen(lambda: self.leaving.emit(tr("The screen was locked")), self._on_power)

    def _on_power(self, message: int, argument: int) -> None:
        if message == CAN_SLEEP:
            self._native.allow_power_change(argument)
        elif message == WILL_SLEEP:
            self._sleep_argument = argument
            self._wait.start()
            self.leaving.emit(tr("The computer is going to sleep"))

    def _allow(self) -> None:
        self._native.allow_power_change(self._sleep_argument)
