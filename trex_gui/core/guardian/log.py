"""Log of the guardian processes, with one line for each stop."""

import os
import re
from enum import StrEnum
from pathlib import Path

from trex_gui.core.files import data_folder, open_ordinary

_LINE = re.compile(r"(?m)^(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d) (confirmed|unconfirmed|repeated): ")
_MAX_READ = 65536  # bytes per read


class StopResult(StrEnum):
    """Result of a stop. `REPEATED`: the program responded again and repeated the stop."""

    CONFIRMED = "confirmed"
    UNCONFIRMED = "unconfirmed"
    REPEATED = "repeated"


def log_file() -> Path:
    return data_folder() / "guardian.log"


def logged_stops(seen: int) -> tuple[int, list[tuple[str, StopResult]]]:
    """Return the size of the log in bytes, and the stops logged after the first `seen` bytes.

    Each stop is a pair of time and result. An unreadable log counts as empty.
    """
    try:
        with open_ordinary(log_file()) as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(seen if seen <= size else 0, size - _MAX_READ))
            text = file.read(_MAX_READ).decode(errors="replace")
    except OSError:
        return 0, []
    return size, [(time, StopResult(result)) for time, result in _LINE.findall(text)]
