"""What guardian processes did: a line in a file for each time that one stopped motors."""

import os
import re
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from trex_gui.core.files import data_folder, open_ordinary

_LINE = re.compile(r"(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d) (\w+): .*")
_LARGEST = 65536  # bytes that are read at once


class StopResult(StrEnum):
    """`REPEATED`: the program responded again meanwhile, and stopped the motors itself."""

    CONFIRMED = "confirmed"
    UNCONFIRMED = "unconfirmed"
    REPEATED = "repeated"


@dataclass(frozen=True, slots=True)
class LoggedStop:
    """A stop that a guardian has sent; `time` is local, as text."""

    time: str
    result: StopResult


def log_file() -> Path:
    return data_folder() / "guardian.log"


def last_stop(seen: int) -> tuple[int, LoggedStop | None]:
    """Return how long the log is in bytes, and the last stop behind its first `seen` bytes.

    A log that cannot be read counts as empty.
    """
    try:
        with open_ordinary(log_file()) as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(seen if seen <= size else 0, size - _LARGEST))
            lines = file.read(_LARGEST).decode(errors="replace").splitlines()
    except OSError:
        return 0, None
    for line in reversed(lines):
        if (found := _LINE.fullmatch(line)) and found[2] in set(StopResult):
            return size, LoggedStop(found[1], StopResult(found[2]))
    return size, None
