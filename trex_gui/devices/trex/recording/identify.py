"""Of what a recording is, told without reading more than its head."""

import json
from pathlib import Path

from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.trex.recording.columns import cells_of, several_lines
from trex_gui.devices.trex.recording.layout import MAGIC
from trex_gui.devices.trex.recording.reader import TrexrecFile
from trex_gui.devices.trex.recording.recording import Header

_LONGEST_HEAD = 1 << 18
_LONGEST_NAME = 60


def recorded_device(path: Path) -> str:
    """Return the device that a recording says it is of; empty where the file is none.

    A board is named with its firmware; the header of any other device's recording names that
    device under `robot`.
    """
    try:
        with path.open("rb") as file:
            names = file.readline(_LONGEST_HEAD)
            if names.startswith(b"time_s,"):
                return _name_in(several_lines(cells_of(file.readline(_LONGEST_HEAD))[-1]))
        if not names.startswith(MAGIC):
            return ""
        recording = TrexrecFile(path, head_only=True)
    except (OSError, ValueError, RecordingError):
        return ""
    recording.close()
    return recording.header.board


def wrong_device_message(path: Path) -> str:
    """Say what the recording of another device is and how it opens; empty where it is none."""
    device = recorded_device(path)
    if not device:
        return ""
    return (
        f"This is a recording of another device: {device}. It opens where the window shows the "
        "pages of that device: choose its port or its demo in the list of ports, then open the "
        "file again."
    )


def _name_in(header: str) -> str:
    try:
        return Header.from_json(header).board
    except ValueError:
        pass
    try:
        about = json.loads(header)
    except (ValueError, RecursionError):
        return ""
    name = about.get("robot") if isinstance(about, dict) else None
    return name[:_LONGEST_NAME] if isinstance(name, str) else ""
