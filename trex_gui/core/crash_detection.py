"""Crash detection with a file that exists while the program runs."""

import faulthandler
import os
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import TextIO

from trex_gui.core.files import log_folder, open_ordinary
from trex_gui.version import __version__

if sys.platform != "win32":
    import fcntl


def crash_file() -> Path:
    return log_folder() / "crash.txt"


class RunFile:
    """File of this run. After a crash it contains the stacks of all threads.

    `found_crash`: True if an earlier run crashed. The file of that run has been renamed to
    `crash_file`. Without a writable folder, no crash is detected.
    """

    def __init__(self) -> None:
        self.found_crash = _rename_abandoned()
        self._file: TextIO | None = None
        name = f"run-{os.getpid()}-{os.urandom(4).hex()}.txt"
        with suppress(OSError):
            log_folder().mkdir(parents=True, exist_ok=True)
            self._file = (log_folder() / name).open("x", encoding="utf-8")
            if sys.platform != "win32":
                fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self._file.write(f"TReX Studio {__version__}, started {time.ctime()}\n")
            self._file.flush()
            faulthandler.enable(self._file)

    def close(self) -> None:
        if self._file is not None:
            faulthandler.disable()
            with suppress(OSError):
                self._file.close()
                Path(self._file.name).unlink()


def _rename_abandoned() -> bool:
    """Rename the files of dead processes to `crash_file`. Return whether there were any."""
    found = False
    for path in log_folder().glob("run-*.txt"):
        with suppress(OSError):  # on Windows an open file cannot be renamed
            if not is_locked(path):
                path.replace(crash_file())
                found = True
    return found


def is_locked(path: Path) -> bool:
    """Return whether the process that locked a file is still running."""
    try:
        if sys.platform == "win32":
            path.replace(path)  # fails while the file is open
        else:
            with open_ordinary(path) as file:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return True
    return False
