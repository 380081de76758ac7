"""SIGTERM, SIGINT, SIGHUP … stop the motors even while the window's thread is busy.

Python runs its handlers in the main thread only, and only between two steps of Python: a window
that waits for something never gets there. But the interpreter writes each signal's number into a
file descriptor at once, and a thread of its own reads it.
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
from types import FrameType
from typing import Any

from PySide6.QtCore import QObject, Signal

log = logging.getLogger(__name__)

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGBREAK")
"""Those that ask a program to end; not every system has each of them."""

_SUSPENDING = "SIGTSTP"
"""Ctrl-Z: the program stands still until somebody lets it go on, and motors must not turn until
then."""

_GRACE_S = 7.0
"""Seconds that the window has to end by itself. Closing a line while settings are written may take
three, and a disk that is recorded to three more; whoever sends signals to end a system waits longer
than that before SIGKILL."""

_HURRYING = {"SIGINT", "SIGQUIT", "SIGBREAK"}
"""Those that a person sends with a key: once more means not to wait."""

_SAME_S = 0.3
"""Seconds within which a second one is the first: a terminal and a program that was started in it
may both pass on one Ctrl-C."""

_LAST_WORD_S = 0.3
"""Seconds for a last stop to leave: at 1200 baud the transaction in flight takes a quarter."""


def _stand_still() -> None:
    os.kill(os.getpid(), signal.SIGSTOP)


def _nothing(_number: int, _frame: FrameType | None) -> None:
    """Keep the signal from ending the process; the watching thread has been told."""


class SignalWatch(QObject):
    """Watches for the end that somebody outside wants; to be made in the main thread.

    A window that does not end within a few seconds is ended: exit code 128 + number then, as a
    shell reports it. One that ends by itself has done all that was asked of it: exit code 0.

    Whoever presses Ctrl-C while it is ending does not want to wait: `act` is called once more,
    and the process is ended at once.

    Before Ctrl-Z suspends it `rest` is called, which has a moment to take effect.

    `act` and `rest` are called in a thread of its own, before anything else. They must not block.
    A signal that was to be ignored from the beginning (`nohup`) is.

    Signals:
        caught: the number of the signal; in the thread of the receiver.
    """

    caught = Signal(int)

    def __init__(
        self,
        act: Callable[[], None],
        rest: Callable[[], None],
        parent: QObject | None = None,
        *,
        grace: float = _GRACE_S,
        end: Callable[[int], Any] = os._exit,
        stand_still: Callable[[], Any] = _stand_still,
    ) -> None:
        super().__init__(parent)
        self._act = act
        self._rest = rest
        self._stand_still = stand_still
        self._grace = grace
        self._end = end
        self._closed = threading.Event()
        self._numbers = [
            number
            for name in (*_NAMES, _SUSPENDING)
            if (number := getattr(signal, name, None)) is not None
            and signal.getsignal(number) is not signal.SIG_IGN
        ]
        self._hurrying = {int(one) for one in self._numbers if one.name in _HURRYING}
        self._ours, self._signals = socket.socketpair()
        self._signals.setblocking(False)
        self._fd_before = signal.set_wakeup_fd(self._signals.fileno(), warn_on_full_buffer=False)
        self._before = {number: signal.signal(number, _nothing) for number in self._numbers}
        self._thread = threading.Thread(target=self._watch, name="signal watch", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Give the signals back; for the end of the program."""
        self._closed.set()
        signal.set_wakeup_fd(self._fd_before)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._signals.close()  # which ends the reading
        if threading.current_thread() is not self._thread:
            self._thread.join(1)
        self._ours.close()

    def _watch(self) -> None:
        with contextlib.suppress(OSError):
            while data := self._ours.recv(16):
                for number in data:
                    if number == getattr(signal, _SUSPENDING, None):
                        self._suspend()
                    elif number in self._numbers:
                        self._leave(number)

    def _suspend(self) -> None:
        self._do(self._rest)
        self._closed.wait(_LAST_WORD_S)
        self._stand_still()  # here it goes on when it is let

    def _leave(self, number: int) -> None:
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
        except Exception:  # whatever it is, this thread lives on and the process has to end
            log.exception("on a signal")

    def _wait_for_hurry(self) -> int | None:
        """Wait as long as the window may take; return the signal that says not to, if one comes."""
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
