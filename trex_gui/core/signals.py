"""Signals of the operating system that end or suspend a program. No system has all of them."""

import signal
from collections.abc import Iterable

ENDING = (
    "SIGINT",
    "SIGTERM",
    "SIGHUP",
    "SIGQUIT",
    "SIGBREAK",
    # Nothing in the program uses the rest.
    "SIGUSR1",
    "SIGUSR2",
    "SIGALRM",
    "SIGVTALRM",
    "SIGPROF",
    "SIGXCPU",
    "SIGIO",
    "SIGPWR",
)
"""Signals that end a program by default and may be handled instead.

Signals of faults (SIGSEGV) are left out, since their handlers must not run Python, and so are
signals that Python ignores (SIGPIPE)."""

SUSPENDING = "SIGTSTP"  # Ctrl-Z: the program is suspended, and motors must not turn meanwhile

FROM_TERMINAL = ("SIGTTIN", "SIGTTOU")
"""Signals for reading from or writing to a terminal in the background.

They suspend a program by default. If they are ignored, writing goes on and reading fails, which
suits a program that moves motors and needs no terminal. A handler would be called for ever, since
Python repeats what a signal interrupts."""


def handled_signals(names: Iterable[str]) -> list[signal.Signals]:
    """Return the signals that exist here, are not ignored (`nohup`) and have no foreign handler."""
    numbers = (getattr(signal, name, None) for name in names)
    # A handler that was not installed in Python is reported as `None`.
    not_ours = (signal.SIG_IGN, None)
    return [n for n in numbers if n is not None and signal.getsignal(n) not in not_ours]
