"""Signals that end or suspend a program. No system has all these signals."""

import signal
from collections.abc import Iterable

ENDING = (
    "SIGINT",
    "SIGTERM",
    "SIGHUP",
    "SIGQUIT",
    "SIGBREAK",
    # This program never uses the following signals itself.
    "SIGUSR1",
    "SIGUSR2",
    "SIGALRM",
    "SIGVTALRM",
    "SIGPROF",
    "SIGXCPU",
    "SIGIO",
    "SIGPWR",
)
"""Signals that end a program by default and that a program can handle.

Fault signals such as SIGSEGV are excluded, because their handlers must not run Python code. SIGPIPE
is excluded, because Python ignores it."""

SUSPENDING = "SIGTSTP"  # sent by Ctrl-Z; a suspended program cannot stop motors

FROM_TERMINAL = ("SIGTTIN", "SIGTTOU")
"""Signals for terminal access from the background.

By default they suspend a program. If they are ignored, writing works and reading fails. This suits
a program that moves motors and does not need a terminal. A handler would be called over and
over, because Python repeats the interrupted call."""


def handled_signals(names: Iterable[str]) -> list[signal.Signals]:
    """Return the signals that the program may handle.

    Excludes signals that do not exist on this system, signals that are ignored (`nohup`), and
    signals with a handler that was not installed in Python.
    """
    numbers = (getattr(signal, name, None) for name in names)
    excluded = (signal.SIG_IGN, None)  # `None`: a handler that was not installed in Python
    return [n for n in numbers if n is not None and signal.getsignal(n) not in excluded]
