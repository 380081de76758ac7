"""Signals that end or suspend a program. No system has all of them."""

import signal
from collections.abc import Iterable

ENDING = (
    "SIGINT",
    "SIGTERM",
    "SIGHUP",
    "SIGQUIT",
    "SIGBREAK",
    # The program itself never uses the following signals.
    "SIGUSR1",
    "SIGUSR2",
    "SIGALRM",
    "SIGVTALRM",
    "SIGPROF",
    "SIGXCPU",
    "SIGIO",
    "SIGPWR",
)
"""Signals that end a program by default and can be handled.

Fault signals (SIGSEGV) are excluded, because their handlers must not run Python. SIGPIPE is
excluded, because Python ignores it."""

SUSPENDING = "SIGTSTP"  # Ctrl-Z: a suspended program cannot stop motors

FROM_TERMINAL = ("SIGTTIN", "SIGTTOU")
"""Signals for terminal access from the background.

They suspend a program by default. If they are ignored, writing works and reading fails, which
suits a program that moves motors and needs no terminal. A handler would be called for ever, since
Python repeats the interrupted call."""


def handled_signals(names: Iterable[str]) -> list[signal.Signals]:
    """Return the signals that the program may handle.

    Excludes signals that the system lacks, that are ignored (`nohup`) or that have a foreign
    handler.
    """
    numbers = (getattr(signal, name, None) for name in names)
    # A handler that was not installed in Python is reported as `None`.
    not_ours = (signal.SIG_IGN, None)
    return [n for n in numbers if n is not None and signal.getsignal(n) not in not_ours]
