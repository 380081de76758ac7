"""Folder for the automatic recordings of faults and stops."""

import contextlib
import re
from datetime import datetime
from pathlib import Path

from trex_gui.core.files import data_folder
from trex_gui.core.recording.store import SUFFIX, remove_recording, reported
from trex_gui.core.translation import tr_noop

MAX_FILES = 50  # about 10 MB
MAX_BYTES = 100 * 1024 * 1024

_NOT_USED = tr_noop("The folder cannot be used: {0}.")
_NAME = re.compile(r"\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d\.\d{3}_[a-z-]+" + re.escape(SUFFIX))


def automatic_folder() -> Path:
    return data_folder() / "faults and stops"


def automatic_path(begun: datetime, kind: str) -> Path:
    """Return the path of an automatic recording. `kind`: a word such as `fault`."""
    stamp = begun.strftime("%Y-%m-%d_%H-%M-%S.%f")[:-3]
    return automatic_folder() / f"{stamp}_{kind}{SUFFIX}"


def create_automatic_folder() -> Path:
    """Create the folder if necessary. Raises RecordingError."""
    folder = automatic_folder()
    with reported(folder, _NOT_USED):
        folder.mkdir(parents=True, exist_ok=True)
    return folder


def remove_oldest(max_files: int = MAX_FILES, max_bytes: int = MAX_BYTES) -> None:
    """Remove the oldest recordings beyond the limits. Create the folder if necessary.

    Afterwards, one more recording fits within `max_files`. Never removes the newest recording or a
    file that the user has renamed. Raises RecordingError.
    """
    folder = create_automatic_folder()
    with reported(folder, _NOT_USED):
        recordings = sorted(path for path in folder.iterdir() if _NAME.fullmatch(path.name))
    used = 0
    for number, path in enumerate(reversed(recordings), start=1):
        with contextlib.suppress(OSError):  # the file is missing, or open in another program
            used += path.stat().st_size
            if number > 1 and (number >= max_files or used > max_bytes):
                remove_recording(path)
