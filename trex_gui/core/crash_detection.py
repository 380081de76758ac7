"""Crash detection by a file that exists during a run."""

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
    """File of this run, which receives the thread stacks after a crash.

    `found_crash`: True if an earlier run crashed. Its file is then `crash_file`. Without a writable
    folder, no crash is detected.
    """

    def __init__(self) -> None:
        self.found_crash = _handle_abandoned()
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


def _handle_abandoned() -> bool:
    """Rename files of dead processes to `crash_file`. Return whether any existed."""
    existed = False
    for path in log_folder().glob("run-*.txt"):
        with suppress(OSError):  # on Windows an open file cannot be renamed
            if not is_locked(path):
                path.replace(crash_file())
                existed = True
    return existed


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
