"""Which program has a port open (Linux only)."""

import contextlib
import os
from pathlib import Path

_PROCESSES = Path("/proc")


def holder_of(url: str) -> str | None:
    """Return which program has a port open; `None`: unknown.

    A program that holds a lock on it goes before one that only has it open, and another program
    before this one: `/proc/locks`, then `/proc/PID/fd` (proc(5)).
    """
    path = Path(url)
    with contextlib.suppress(OSError):
        number = _locking(path) or _having_open(path.resolve())
        if number == os.getpid():
            return "another line of this program"
        if number is not None:
            name = (_PROCESSES / str(number) / "comm").read_text(encoding="utf-8").strip()
            return f"{name} (process {number})"
    return None


def is_locked_elsewhere(url: str) -> bool:
    """Whether another program has locked a port; true if that is unknown."""
    with contextlib.suppress(OSError):
        return _locking(Path(url)) not in {None, os.getpid()}
    return True


def _locking(path: Path) -> int | None:
    status = path.stat()
    major, minor = os.major(status.st_dev), os.minor(status.st_dev)
    wanted = f"{major:02x}:{minor:02x}:{status.st_ino}"
    for line in (_PROCESSES / "locks").read_text(encoding="ascii").splitlines():
        match line.split():
            case [_, "FLOCK", _, _, number, where, *_] if where == wanted and number.isdecimal():
                return int(number)
    return None


def _having_open(path: Path) -> int | None:
    ours = str(os.getpid())
    for link in _PROCESSES.glob("[0-9]*/fd/*"):
        with contextlib.suppress(OSError):
            if link.readlink() == path and link.parts[2] != ours:
                return int(link.parts[2])
    return None
