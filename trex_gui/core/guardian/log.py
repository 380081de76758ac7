"""Log of the guardian processes: a line for each time that one stopped motors."""

import os
import re
from enum import StrEnum
from pathlib import Path

from trex_gui.core.files import data_folder, open_ordinary

_LINE = re.compile(r"(?m)^(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d) (confirmed|unconfirmed|repeated): ")
_LARGEST = 65536  # bytes that are read at once


class StopResult(StrEnum):
    """`REPEATED`: the program responded again meanwhile, and stopped the motors itself."""

    CONFIRMED = "confirmed"
    UNCONFIRMED = "unconfirmed"
    REPEATED = "repeated"


def log_file() -> Path:
    return data_folder() / "guardian.log"


def logged_stops(seen: int) -> tuple[int, list[tuple[str, StopResult]]]:
    """Return the size of the log in bytes, and time and result of each stop after `seen` bytes.

    A log that cannot be read counts as empty.
    """
    try:
        with open_ordinary(log_file()) as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(seen if seen <= size else 0, size - _LARGEST))
            text = file.read(_LARGEST).decode(errors="replace")
    except OSError:
        return 0, []
    return size, [(time, StopResult(result)) for time, result in _LINE.findall(text)]
