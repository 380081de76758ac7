"""Stop of the motors on signals such as SIGTERM, even while the window is busy.

Python runs signal handlers only in the main thread, between two bytecode instructions. A blocked
window never runs them. Therefore a separate thread reads the signal numbers that the interpreter
writes into a file descriptor at once.
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
"""Seconds for the window to end by itself. Closing a line during a write may take three seconds,
and saving a recording three more. A system that shuts down waits longer before SIGKILL."""

_HURRYING = {"SIGINT", "SIGQUIT", "SIGBREAK"}  # sent by keys; a second signal ends the wait

_DEBOUNCE_S = 0.3
"""Seconds in which a second signal is a duplicate of the first. A terminal and a program started in
it may both forward one Ctrl-C."""

_LAST_STOP_S = 0.3  # seconds to send a last stop; a transaction at 1200 baud takes 0.25 s


def _suspend_process() -> None:
    os.kill(os.getpid(), signal.SIGSTOP)


class SignalWatch(QObject):
    """Handles signals that end or suspend the program. Create it in the main thread.

    A signal first calls `act`. If the window does not end within `grace` seconds, the process ends
    with exit code 128 + signal number, like a shell. Another Ctrl-C calls `act` again and ends the
    process. Ctrl-Z calls `rest` shortly before it suspends the process. Terminal access in the
    background does not suspend the process.

    `act` and `rest` are called in a separate thread and must not block. A signal that is ignored
    at the start (`nohup`) stays ignored.
    """

    caught = Signal(int)  # signal number; delivered in the receiver's thread

    def __init__(
        self,
        act: Callable[[], None],
        rest: Callable[[], None],
        parent: QObject | None = None,
        *,
        grace: float = _GRACE_S,
        end: Callable[[int], Any] = os._exit,
        suspend: Callable[[], Any] = _suspend_process,
    ) -> None:
        super().__init__(parent)
        self._act = act
        self._rest = rest
        self._suspend_process = suspend
        self._grace = grace
        self._end = end
        self._closed = threading.Event()
        self._numbers = handled_signals((*ENDING, SUSPENDING))
        self._hurrying = {int(number) for number in self._numbers if number.name in _HURRYING}
        self._reader, self._writer = socket.socketpair()
        self._writer.setblocking(False)
        self._fd_before = signal.set_wakeup_fd(self._writer.fileno(), warn_on_full_buffer=False)
        # These handlers only prevent the end of the process. The thread handles the signals.
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
        self._run(self._rest)
        self._closed.wait(_LAST_STOP_S)
        self._suspend_process()  # returns when the process is resumed

    def _exit(self, number: int) -> None:
        self._run(self._act)
        self._run(partial(self.caught.emit, number))
        hurry = self._wait_for_hurry()
        if hurry is not None:
            self._run(self._act)
            self._closed.wait(_LAST_STOP_S)
        if not self._closed.is_set():
            self._end(128 + (hurry or number))

    def _run(self, step: Callable[[], object]) -> None:
        try:
            step()
        except Exception:  # this thread must survive in order to end the process
            log.exception("on a signal")

    def _wait_for_hurry(self) -> int | None:
        """Wait until the window ends or `grace` expires. Return a signal to end at once, if any."""
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
                break  # closed, because the window has ended
            repeated = set(data) & self._hurrying
            if repeated and time.monotonic() - start >= _DEBOUNCE_S:
                return repeated.pop()
        return None
