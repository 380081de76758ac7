"""Boards left running, because the program and its guardian died before confirming a stop.

While motors may move, the guardian maintains a locked file (see `guardian.process`). A file that is
not locked describes a board whose stop is not confirmed.
"""

import logging
import os
import re
import signal
import socket
import threading
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit

from serial.tools import list_ports

from trex_gui.core.crash_detection import is_locked
from trex_gui.core.errors import PortFault, PortUnavailable
from trex_gui.core.files import data_folder, open_ordinary
from trex_gui.core.guardian.guardian import StopSequence
from trex_gui.core.guardian.process import FINISHED, StopMessage
from trex_gui.core.translation import tr, tr_noop
from trex_gui.core.transport.adapters import adapter_key
from trex_gui.core.transport.settings import Parity, PortSettings, SerialFormat

_STOPPED = tr_noop(
    "The motors of the {0} at {1}, driven since {2}, were left running. The board now "
    "connected there has confirmed a stop. If a motor is still turning, cut its power."
)


class DrivenBoard(NamedTuple):
    """Contents of a board's file. `since`: local time as text."""

    board: str
    settings: PortSettings
    stop: StopSequence
    since: str

    def text(self, *, stopped: bool = False) -> str:
        text = _STOPPED if stopped else PortFault.LEFT_RUNNING.value
        return tr(text).format(self.board, self.settings.url, self.since)


DrivenBoards = dict[Path, DrivenBoard | None]
"""File of a board → board. `None`: the file is damaged."""

_resumed: dict[Path, DrivenBoard] = {}  # boards whose suspended guardian has been resumed
# Files in /proc/PID, and texts that these files contain for a suspended guardian.
_SUSPENDED = (("status", "(stopped)"), ("cmdline", "guardian"))
_warn_once = cache(logging.getLogger(__name__).warning)


def driven_note(board: str, settings: PortSettings) -> str:
    """Return the lines of a board's file that describe the board and its port."""
    line = f"{settings.line.baud} {settings.line.parity.value} {settings.line.stop_bits}"
    return f"board: {board}\nport: {settings.url}\nline: {line}\n"


def driven_boards() -> DrivenBoards:
    """Return the boards left running. Log each board only once."""
    boards_read: DrivenBoards = {}
    thread = threading.Thread(target=_read_files, args=(boards_read,), daemon=True)
    thread.start()
    thread.join(0.5)  # after this time, a disk that does not respond counts as empty
    boards = dict(boards_read)
    for file, board in boards.items():
        _warn_once("%s", left_running_text(file, board))
    return boards


def left_running_text(file: Path, board: DrivenBoard | None) -> str:
    return tr(PortFault.LEFT_UNKNOWN.value).format(file) if board is None else board.text()


def driven_at(url: str) -> tuple[Path, DrivenBoard | None]:
    """Return the file of a port and its board. The caller must stop the board."""
    boards = driven_boards()
    files = (file for file, board in boards.items() if board and _is_at(file, board, url))
    file = next(files, driven_file(url))
    _resumed.pop(file, None)
    return file, boards.get(file)


def driven_file(url: str) -> Path:
    """Return the file of a port.

    An adapter has the same file at every port. A network address has the same file under every host
    name.
    """
    key = adapter_key(url) or (url if "://" in url else os.path.realpath(url.replace("\0", "")))
    with suppress(OSError, ValueError):
        parts = urlsplit(url)
        if parts.hostname and parts.port:
            key = f"{socket.gethostbyname(parts.hostname)}:{parts.port}"
    return data_folder() / "driven" / f"{re.sub(r'[^A-Za-z0-9.]+', '-', key)[-100:]}.txt"


def port_of(file: Path, board: DrivenBoard) -> PortSettings:
    """Return the current port of a board. Raises PortUnavailable."""
    for url in (board.settings.url, *(port.device for port in list_ports.comports())):
        if _is_at(file, board, url):
            return PortSettings(url, board.settings.line)
    raise PortUnavailable(tr(PortFault.GONE.value).format(board.settings.url), is_missing=True)


def _is_at(file: Path, board: DrivenBoard, url: str) -> bool:
    """Return whether a file belongs to a port, even if a link to the port has changed."""
    is_path = file.name.startswith("-")
    return file == driven_file(url) or (is_path and url == board.settings.url)


def _read_files(boards: DrivenBoards) -> None:
    paths: list[Path] = []
    with suppress(OSError):  # the name of the data folder may be too long
        paths += (data_folder() / "driven").glob("*.txt")
    for path in paths:
        with suppress(OSError):
            has_guardian = is_locked(path)  # before reading, since a guardian may remove the file
            try:
                board, pid = _read(path)
            except (ValueError, TypeError):
                if not has_guardian:
                    boards[path] = None
                continue
            if not has_guardian:
                boards[path] = board
            elif all(words in Path("/proc", pid, file).read_text() for file, words in _SUSPENDED):
                _resumed[path] = board
                os.kill(int(pid), signal.SIGCONT)  # the guardian now stops the motors
    boards.update(_resumed)


def _read(path: Path) -> tuple[DrivenBoard, str]:
    """Return a file's board, and the process ID of its guardian.

    Raises:
        ValueError, TypeError: the file is damaged.
        OSError: there is no such file, or its guardian is removing it.
    """
    with open_ordinary(path) as file:
        content = file.read(4096)
    if content == FINISHED:
        raise FileNotFoundError(path)
    lines = content.decode(errors="replace").splitlines()
    name, pid, line, url, since, stop = (text.partition(": ")[2] for text in sorted(lines))
    baud, parity, stop_bits = line.split()
    settings = PortSettings(url, SerialFormat(int(baud), Parity(parity), int(stop_bits)))
    note = f"{driven_note(name, settings)}since: {since}\n"
    sequence = vars(StopMessage([*stop.split(), ""])) | {"note": note}
    return DrivenBoard(name, settings, StopSequence(**sequence), since), pid
