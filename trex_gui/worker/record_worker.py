"""The thread that writes a recording, so that a slow disk holds up neither line nor window."""

import contextlib
import os
import time
from pathlib import Path
from typing import BinaryIO

from PySide6.QtCore import QObject, QThread, Signal

from trex_gui.recording.backlog import Backlog
from trex_gui.recording.files import writer_for
from trex_gui.recording.recording import Header, Writer

_LOOK = 0.5
"""Seconds after which the size is told again."""

_SAFE = 5.0
"""Seconds after which what was recorded is on the disk: as much is lost with the power."""


class RecordWorker(QThread):
    """Writes one recording; ends when its backlog is closed, or when the disk refuses.

    Signals:
        progressed: bytes written so far.
        failed: why the recording has ended before it should, for people.
    """

    progressed = Signal(object)
    failed = Signal(str)

    def __init__(
        self, path: Path, header: Header, backlog: Backlog, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("RecordWorker")
        self._path = path
        self._header = header
        self._backlog = backlog

    def run(self) -> None:
        """Write until the end; called by Qt in the new thread."""
        try:
            with self._path.open("wb") as file:
                self._write(file)
        except (OSError, ValueError) as error:
            self._backlog.close(self._header.clock)
            reason = getattr(error, "strerror", None) or error
            self.failed.emit(self.tr("{0} cannot be written: {1}.").format(self._path, reason))

    def _write(self, file: BinaryIO) -> None:
        writer = writer_for(self._path, file, self._header)
        safe_at = time.monotonic() + _SAFE
        self.progressed.emit(writer.size)
        while (records := self._backlog.get(_LOOK)) is not None:
            writer.write(records)
            now = time.monotonic()
            if now >= safe_at:
                safe_at = now + _SAFE
                _save(writer, file)
            self.progressed.emit(writer.size)
        writer.finish()
        _sync(file)
        self.progressed.emit(writer.size)


def _save(writer: Writer, file: BinaryIO) -> None:
    writer.flush()
    file.flush()
    _sync(file)


def _sync(file: BinaryIO) -> None:
    """Bring a file down to the disk, where it is one: a pipe has none."""
    with contextlib.suppress(OSError):
        os.fsync(file.fileno())
