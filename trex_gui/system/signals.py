"""Stop of the motors on a signal such as SIGTERM, even while the window's thread is busy.

Python runs signal handlers only in the main thread, between two steps of Python code. A window
that waits never reaches them. But the interpreter writes each signal's number into a file
descriptor at once, and a separate thread reads it.
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
"""Seconds for the window to end by itself. Closing a line while settings are written may take
three, and a disk with a recording three more. A system that shuts down waits longer before
SIGKILL."""

_HURRYING = {"SIGINT", "SIGQUIT", "SIGBREAK"}
"""Signals sent by a key. A second signal ends the process without waiting."""

_SAME_S = 0.3
"""Seconds within which a second signal counts as the first. A terminal and a program that was
started in it may both pass on one Ctrl-C."""

_LAST_WORD_S = 0.3
"""Seconds to send a last stop. At 1200 baud the transaction in flight takes 0.25 s."""


def _suspend_process() -> None:
    os.kill(os.getpid(), signal.SIGSTOP)


class SignalWatch(QObject):
    """Handles signals that end or suspend the program. Create it in the main thread.

    If the window does not end within `grace` seconds, the process ends with exit code 128 + number,
    as a shell reports it, else with 0. Ctrl-C in the meantime calls `act` once more and ends the
    process at once. Before Ctrl-Z suspends the process, `rest` is called and has a moment to take
    effect. Use of a terminal in the background does not suspend the process.

    `act` and `rest` are called in a separate thread, before anything else. They must not block.
    A signal that is ignored from the start (`nohup`) stays ignored.
    """

    caught = Signal(int)  # the number of the signal; in the thread of the receiver

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
        self._hurrying = {int(one) for one in self._numbers if one.name in _HURRYING}
        self._ours, self._signals = socket.socketpair()
        self._signals.setblocking(False)
        self._fd_before = signal.set_wakeup_fd(self._signals.fileno(), warn_on_full_buffer=False)
        # The handlers only prevent the end of the process. The thread handles the signals.
        self._before = {number: signal.signal(number, lambda *_: None) for number in self._numbers}
        for number in handled_signals(FROM_TERMINAL):
            self._before[number] = signal.signal(number, signal.SIG_IGN)
        self._thread = threading.Thread(target=self._watch, name="signal watch", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Restore the handlers, at the end of the program."""
        self._closed.set()
        signal.set_wakeup_fd(self._fd_before)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._signals.close()  # ends the reading thread
        if threading.current_thread() is not self._thread:
            self._thread.join(1)
        self._ours.close()

    def _watch(self) -> None:
        with contextlib.suppress(OSError):
            while data := self._ours.recv(16):
                for number in data:
                    if number == getattr(signal, SUSPENDING, None):
                        self._suspend()
                    elif number in self._numbers:
                        self._exit(number)

    def _suspend(self) -> None:
        self._do(self._rest)
        self._closed.wait(_LAST_WORD_S)
        self._suspend_process()  # returns when the process is resumed

    def _exit(self, number: int) -> None:
        self._do(self._act)
        self._do(partial(self.caught.emit, number))
        hurry = self._wait_for_hurry()
        if hurry is not None:
            self._do(self._act)
            self._closed.wait(_LAST_WORD_S)
        if not self._closed.is_set():
            self._end(128 + (hurry or number))

    def _do(self, step: Callable[[], object]) -> None:
        try:
            step()
        except Exception:  # this thread must continue, and the process must end
            log.exception("on a signal")

    def _wait_for_hurry(self) -> int | None:
        """Wait until the window has ended or `grace` is over. Return a signal to hurry, if any."""
        begun = time.monotonic()
        while (left := begun + self._grace - time.monotonic()) > 0:
            self._ours.settimeout(left)
            try:
                data = self._ours.recv(16)
            except TimeoutError:
                break
            finally:
                self._ours.settimeout(None)
            if not data:
                break  # closed: the window has ended
            if time.monotonic() - begun >= _SAME_S and (again := set(data) & self._hurrying):
                return again.pop()
        return None
