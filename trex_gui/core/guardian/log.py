"""Log of the guardian processes, with a line for each stop."""

import os
import re
from enum import StrEnum
from pathlib import Path

from trex_gui.core.files import data_folder, open_ordinary

_LINE = re.compile(r"(?m)^(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d) (confirmed|unconfirmed|repeated): ")
_LARGEST = 65536  # bytes of one read


class StopResult(StrEnum):
    """Result of a stop. `REPEATED`: the program responded and stopped the motors."""

    CONFIRMED = "confirmed"
    UNCONFIRMED = "unconfirmed"
    REPEATED = "repeated"


def log_file() -> Path:
    return data_folder() / "guardian.log"


def logged_stops(seen: int) -> tuple[int, list[tuple[str, StopResult]]]:
    """Return the log's size in bytes, and its stops after `seen` bytes.

    A stop is its time and its result. An unreadable log counts as empty.
    """
    try:
        with open_ordinary(log_file()) as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(seen if seen <= size else 0, size - _LARGEST))
            text = file.read(_LARGEST).decode(errors="replace")
    except OSError:
        return 0, []
    return size, [(time, StopResult(result)) for time, result in _LINE.findall(text)]
