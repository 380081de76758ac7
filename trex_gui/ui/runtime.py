"""Clock, timers, threads and ports of the program.

Tests replace the runtime before they create a window, and run in virtual time. The process has
one runtime, because passing it down to every timer would clutter the widgets.
"""

import threading
import time
from collections.abc import Callable

from PySide6.QtCore import QDeadlineTimer, QObject, QProcess, QThread, QTimer

from trex_gui.core.session import Condition
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings


class Runtime:
    def now(self) -> float:
        return time.monotonic()

    def sleep(self, seconds: float) -> None:
        time.sleep(seconds)

    def condition(self) -> Condition:
        return threading.Condition()

    def timer(self, parent: QObject) -> QTimer:
        return QTimer(parent)

    def start(self, thread: QThread, priority: QThread.Priority) -> None:
        QThread.start(thread, priority)

    def wait(self, thread: QThread, milliseconds: int) -> bool:
        """Wait for a thread to end. Return whether it has ended. -1 ms waits forever."""
        return QThread.wait(thread, QDeadlineTimer(milliseconds))

    def process(self, parent: QObject) -> QProcess:
        return QProcess(parent)

    def open_transport(self, settings: PortSettings) -> Transport:
        return SerialTransport(settings)


_runtime = Runtime()


def runtime() -> Runtime:
    return _runtime


def use_runtime(runtime: Runtime) -> Runtime:
    global _runtime
    previous, _runtime = _runtime, runtime
    return previous


def new_timer(
    parent: QObject, milliseconds: int, then: Callable[[], object], *, single_shot: bool = False
) -> QTimer:
    """Create a timer without starting it. With 0 ms, it fires after the current event."""
    timer = _runtime.timer(parent)
    timer.setInterval(milliseconds)
    timer.setSingleShot(single_shot)
    timer.timeout.connect(then)
    return timer


def now() -> float:
    return _runtime.now()


def open_transport(settings: PortSettings) -> Transport:
    return _runtime.open_transport(settings)
