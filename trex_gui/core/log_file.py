"""Log file of the program, limited in size.

A thread writes the file. If the disk is slow, full or read-only, only log entries are lost.
"""

import logging
import sys
import threading
from contextlib import suppress
from io import TextIOWrapper
from logging.handlers import QueueHandler, QueueListener, RotatingFileHandler
from pathlib import Path
from queue import SimpleQueue

from trex_gui.core.files import check_ordinary, log_folder
from trex_gui.core.texts import counted

_MAX_SIZE = 512 * 1024  # bytes per file
_OLDER_FILES = 3  # number of older files in addition to the newest file
_MAX_LENGTH = 20_000  # characters per entry, including the traceback
_MAX_QUEUED = 10_000  # entries queued for a slow disk
_REPEATED_S = 60.0
"""Period in seconds within which a repeated entry is only counted.

Otherwise an error that repeats thirty times a second would displace all other entries."""


def log_file() -> Path:
    return log_folder() / "trex-gui.log"


def log_files() -> list[Path]:
    """Return the paths of all log files, with the newest last. Some files may not exist."""
    path = log_file()
    return [*(path.with_name(f"{path.name}.{age}") for age in range(_OLDER_FILES, 0, -1)), path]


class ProgramLog:
    """Writes log entries to a file, and warnings also to the terminal, until closed.

    An entry with the attribute `printed` has already been printed on the terminal.
    """

    def __init__(self, path: Path, *, is_verbose: bool = False) -> None:
        """`is_verbose`: also log DEBUG entries, and print all entries on the terminal."""
        self._level = logging.getLogger("trex_gui").level
        logging.getLogger("trex_gui").setLevel(logging.DEBUG if is_verbose else logging.INFO)
        self._file = _LogFile(path)
        self._file.setFormatter(_Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
        handlers: list[logging.Handler] = [self._file]
        if sys.stderr is not None:  # `None` without a console on Windows
            handlers.append(terminal_handler(is_verbose=is_verbose))
        entries: SimpleQueue[logging.LogRecord] = SimpleQueue()
        self._handler = _QueueHandler(entries)
        self._listener = QueueListener(entries, *handlers, respect_handler_level=True)
        self._listener.start()
        logging.getLogger().addHandler(self._handler)

    def close(self, timeout: float = 2.0) -> bool:
        """Write the remaining entries. Return False after a timeout (s).

        After a timeout, a normal exit would wait for the disk. Only `os._exit` ends the process at
        once.
        """
        logging.getLogger().removeHandler(self._handler)
        logging.getLogger("trex_gui").setLevel(self._level)
        ending = threading.Thread(target=self._end, daemon=True)
        ending.start()
        ending.join(timeout)
        return not ending.is_alive()

    def _end(self) -> None:
        self._listener.stop()
        self._handler.close()
        with suppress(OSError):
            self._file.close()


def terminal_handler(*, is_verbose: bool) -> logging.Handler:
    handler = logging.StreamHandler()
    handler.setLevel(logging.DEBUG if is_verbose else logging.WARNING)
    if is_verbose:
        handler.setFormatter(_Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    handler.addFilter(lambda record: not hasattr(record, "printed"))
    return handler


class _QueueHandler(QueueHandler):
    """Queues entries without blocking.

    The queue is reentrant, because one log call may interrupt another.
    """

    queue: SimpleQueue[logging.LogRecord]

    def enqueue(self, record: logging.LogRecord) -> None:
        if self.queue.qsize() < _MAX_QUEUED:
            self.queue.put(record)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - Python's name
        """Drop an entry that cannot be formatted."""


class _Formatter(logging.Formatter):
    def format(self, record: logging.LogRecord) -> str:
        text = super().format(record)
        return text if len(text) <= _MAX_LENGTH else f"{text[:_MAX_LENGTH]} …"


class _LogFile(RotatingFileHandler):
    def __init__(self, path: Path) -> None:
        super().__init__(
            path,
            maxBytes=_MAX_SIZE,
            backupCount=_OLDER_FILES,
            encoding="utf-8",
            errors="backslashreplace",
            delay=True,  # opened by the writing thread
        )
        self._last, self._since, self._repeats = "", 0.0, 0

    def _open(self) -> TextIOWrapper:
        path = Path(self.baseFilename)
        path.parent.mkdir(parents=True, exist_ok=True)
        with suppress(FileNotFoundError):
            check_ordinary(path)  # a pipe would block forever
        return super()._open()

    def emit(self, record: logging.LogRecord) -> None:
        text = record.getMessage()
        if text == self._last and record.created - self._since < _REPEATED_S:
            self._repeats += 1
            return
        if self._repeats:
            repeats = counted(self._repeats, "time")
            entry = {"msg": f"the last entry was repeated {repeats}", "name": __name__}
            super().emit(logging.makeLogRecord({"levelname": "INFO", **entry}))
        self._last, self._since, self._repeats = text, record.created, 0
        super().emit(record)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - Python's name
        """Drop an entry that the disk does not accept."""
