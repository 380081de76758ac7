"""Handling of signals such as SIGTERM, which stop the motors even while the window is busy.

Python runs signal handlers only in the main thread, between two bytecode instructions. While the
window is blocked, no handler runs. However, the interpreter writes the number of each signal to a
file descriptor at once. A separate thread reads these numbers.
"""

import contextlib
import logging
import os
import signal
import socket
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal

from trex_gui.core.signals import ENDING, FROM_TERMINAL, SUSPENDING, handled_signals

log = logging.getLogger(__name__)

_GRACE_S = 7.0
"""Seconds that the window has to close normally.

Closing a line during a write may take three seconds, and saving a recording three more. A system
that is shutting down waits longer than this before it sends SIGKILL."""

_KEYBOARD_SIGNALS = {"SIGINT", "SIGQUIT", "SIGBREAK"}  # a second such signal ends the process

_DEBOUNCE_S = 0.3
"""Seconds within which a second signal counts as a duplicate of the first.

A terminal and a program started in it may both pass on a single Ctrl-C."""

_LAST_STOP_S = 0.3  # seconds to send a last stop; a transaction at 1200 baud takes 0.25 s


def _suspend_process() -> None:
    os.kill(os.getpid(), signal.SIGSTOP)


class SignalWatch(QObject):
    """Handles signals that end or suspend the program. Create it in the main thread.

    A signal that ends the program first calls `on_end`. If the window has not closed after `grace`
    seconds, the process ends with the exit code 128 + signal number, as in a shell. Another Ctrl-C
    calls `on_end` again and ends the process. Ctrl-Z calls `on_suspend` and then suspends the
    process. Terminal access from the background does not suspend the process.

    `on_end` and `on_suspend` are called in a separate thread and must not block. A signal that was
    ignored when the program started (`nohup`) stays ignored.
    """

    caught = Signal(int)  # signal number; delivered in the receiver's thread

    def __init__(
        self,
        on_end: Callable[[], None],
        on_suspend: Callable[[], None],
        parent: QObject | None = None,
        *,
        grace: float = _GRACE_S,
        end: Callable[[int], Any] = os._exit,
        suspend: Callable[[], Any] = _suspend_process,
    ) -> None:
        super().__init__(parent)
        self._on_end = on_end
        self._on_suspend = on_suspend
        self._suspend_process = suspend
        self._grace = grace
        self._end = end
        self._closed = threading.Event()
        self._numbers = handled_signals((*ENDING, SUSPENDING))
        self._keyboard_signals = {
            int(number) for number in self._numbers if number.name in _KEYBOARD_SIGNALS
        }
        self._reader, self._writer = socket.socketpair()
        self._writer.setblocking(False)
        self._fd_before = signal.set_wakeup_fd(self._writer.fileno(), warn_on_full_buffer=False)
        # These handlers only keep the process alive. The thread handles the signals.
        self._before = {number: signal.signal(number, lambda *_: None) for number in self._numbers}
        for number in handled_signals(FROM_TERMINAL):
            self._before[number] = signal.signal(number, signal.SIG_IGN)
        self._thread = threading.Thread(target=self._watch, name="signal watch", daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._closed.set()
        signal.set_wakeup_fd(self._fd_before)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._writer.close()  # ends the reading thread
        if threading.current_thread() is not self._thread:
            self._thread.join(1)
        self._reader.close()

    def _watch(self) -> None:
        with contextlib.suppress(OSError):
            while data := self._reader.recv(16):
                for number in data:
                    if number == getattr(signal, SUSPENDING, None):
                        self._suspend()
                    elif number in self._numbers:
                        self._exit(number)

    def _suspend(self) -> None:
        self._run(self._on_suspend)
        self._closed.wait(_LAST_STOP_S)
        self._suspend_process()  # returns when the process is resumed

    def _exit(self, number: int) -> None:
        self._run(self._on_end)
        self._run(partial(self.caught.emit, number))
        repeated = self._wait_for_window()
        if repeated is not None:
            self._run(self._on_end)
            self._closed.wait(_LAST_STOP_S)
        if not self._closed.is_set():
            self._end(128 + (repeated or number))

    def _run(self, function: Callable[[], object]) -> None:
        try:
            function()
        except Exception:  # this thread must survive in order to end the process
            log.exception("the response to a signal failed")

    def _wait_for_window(self) -> int | None:
        """Wait until the window has closed or `grace` expires.

        Another signal from the keyboard ends the wait. Return its number, otherwise `None`.
        """
        start = time.monotonic()
        while (remaining := start + self._grace - time.monotonic()) > 0:
            self._reader.settimeout(remaining)
            try:
                data = self._reader.recv(16)
            except TimeoutError:
                break
            finally:
                self._reader.settimeout(None)
            if not data:
                break  # the watch was closed with the window
            repeated = set(data) & self._keyboard_signals
            if repeated and time.monotonic() - start >= _DEBOUNCE_S:
                return repeated.pop()
        return None
