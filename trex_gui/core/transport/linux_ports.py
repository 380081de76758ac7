"""Information from Linux about a port: processes that use it, and supported baud rates."""

import array
import contextlib
import os
import platform
import sys
import time
from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from typing import Protocol

from trex_gui.core.translation import tr

if sys.platform != "win32":
    import fcntl

_PROCESSES = Path("/proc")


def holder_of(url: str) -> str | None:
    """Return the program that has a port open. `None` if unknown.

    Prefers the program that has locked the port. Otherwise this is any program except this one.
    Reads `/proc/locks`, then `/proc/PID/fd` (proc(5)).
    """
    path = Path(url)
    with contextlib.suppress(OSError):
        others = (pid for pid in _processes_with_open(path) if pid != os.getpid())
        pid = _locking_process(path) or next(others, None)
        if pid == os.getpid():
            return tr("another connection of this program")
        if pid is not None:
            return _name_of(pid)
    return None


def other_user_of(url: str) -> str | None:
    """Return another program that has a port open. `None` if there is none or it is unknown.

    Ignores guardians and programs that serve pseudo-terminals. On a computer with many processes,
    this takes a tenth of a second.
    """
    if sys.platform != "linux":
        return None
    path = Path(url)
    with contextlib.suppress(OSError):
        path.stat()
        for pid in _processes_with_open(path):
            process = _PROCESSES / str(pid)
            is_guardian = b"guardian" in (process / "cmdline").read_bytes()
            if pid != os.getpid() and not is_guardian and not _has_terminals(process):
                return _name_of(pid)
    return None


def _has_terminals(process: Path) -> bool:
    return any(link.readlink().name == "ptmx" for link in (process / "fd").iterdir())


def _name_of(pid: int) -> str:
    name = (_PROCESSES / str(pid) / "comm").read_text(encoding="utf-8").strip()
    return tr("{0} (process {1})").format(name, pid)


def is_locked_elsewhere(url: str) -> bool:
    """Return whether another program has locked a port. True if unknown.

    Ignores the lock of a dead program.
    """
    with contextlib.suppress(OSError):
        pid = _locking_process(Path(url))
        return pid not in {None, os.getpid()} and (_PROCESSES / str(pid)).exists()
    return True


def is_left_to_guardian(url: str) -> bool:
    """Return whether a port is open only in the guardian of a program that has ended.

    Such a guardian is stopping the motors.
    """
    path = Path(url)
    with contextlib.suppress(OSError):
        pids = set(_processes_with_open(path))
        commands = [(_PROCESSES / str(pid) / "cmdline").read_bytes() for pid in pids]
        is_watched = any(b"guardian" in command for command in commands)
        return is_watched and _locking_process(path) not in pids
    return False


def _locking_process(path: Path) -> int | None:
    status = path.stat()
    major, minor = os.major(status.st_dev), os.minor(status.st_dev)
    file_id = f"{major:02x}:{minor:02x}:{status.st_ino}"
    for line in (_PROCESSES / "locks").read_text(encoding="ascii").splitlines():
        match line.split():
            case [_, "FLOCK", _, _, pid, locked_id, *_] if locked_id == file_id and pid.isdecimal():
                return int(pid)
    return None


def _processes_with_open(path: Path) -> Iterator[int]:
    target = Path(os.path.realpath(path))
    for link in _PROCESSES.glob("[0-9]*/fd/*"):
        with contextlib.suppress(OSError):
            if link.readlink() == target:
                yield int(link.parts[2])


# struct termios2 of Linux has four flag words, five words of line discipline and control
# characters, then both rates in bit/s. Processors other than `_PROCESSORS` use other request
# numbers.
_TCGETS2, _TCSETS2 = 0x802C542A, 0x402C542B
_CBAUD, _BOTHER = 0o010017, 0o010000
CFLAG, _ISPEED, OSPEED, _WORDS = 2, 9, 10, 11
_PROCESSORS = ("x86", "i386", "i486", "i586", "i686", "amd64", "arm", "aarch64", "riscv", "loong")

_RATE_TOLERANCE = 0.03  # relative error of a rate, in addition to the error of the board's clock

_TIMEOUT = 0.1  # seconds after which `rates_of` gives up, because it delays opening the port


class _Port(Protocol):
    def fileno(self) -> int: ...


def rates_of(
    port: _Port, wanted: Collection[int], clock: Callable[[], float] = time.monotonic
) -> frozenset[int] | None:
    """Return the wanted rates that an open port supports. `None` if unknown.

    A driver that cannot produce a rate uses the nearest rate and reports it. Each rate
    is set and read back. Then the old settings are restored. Sends nothing and never raises. No
    byte may be in transit.
    """
    if sys.platform != "linux" or not platform.machine().lower().startswith(_PROCESSORS):
        return None
    supported = set()
    deadline = clock() + _TIMEOUT
    try:
        handle = port.fileno()
        original = termios2(handle)
        try:
            for rate in wanted:
                if clock() > deadline:
                    return None
                if abs(_real_rate(handle, original, rate) - rate) <= _RATE_TOLERANCE * rate:
                    supported.add(rate)
        finally:
            fcntl.ioctl(handle, _TCSETS2, original)
    except (AttributeError, OSError, ValueError):
        return None
    return frozenset(supported)


def _real_rate(handle: int, original: "array.array[int]", rate: int) -> int:
    """Set a rate. Return the rate that the driver uses, or 0 if it refuses the rate."""
    words = original[:]
    words[CFLAG] = words[CFLAG] & ~_CBAUD | _BOTHER
    words[_ISPEED] = words[OSPEED] = rate
    try:
        fcntl.ioctl(handle, _TCSETS2, words)
    except OSError:
        return 0
    return termios2(handle)[OSPEED]


def termios2(handle: int) -> "array.array[int]":
    """Return the terminal settings. Raises OSError if the processor uses other request numbers."""
    words = array.array("I", [0] * _WORDS)
    fcntl.ioctl(handle, _TCGETS2, words)
    return words
