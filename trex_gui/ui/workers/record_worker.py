"""The thread that writes a recording, so that a slow disk holds up neither line nor window."""

import contextlib
import logging
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import BinaryIO, Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, Signal

from trex_gui.core.recording.backlog import Backlog
from trex_gui.core.recording.blocks import RecordT
from trex_gui.devices.trex.recording.recording import Marker
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.thread import WorkerThread

log = logging.getLogger(__name__)

_LOOK = 0.5
"""Seconds after which the size is told again."""

_SAFE = 5.0
"""Seconds after which what was recorded is on the disk: as much is lost with the power."""


WrittenT_contra = TypeVar("WrittenT_contra", contravariant=True)


class Writer(Protocol[WrittenT_contra]):
    """What writes records of any kind; see `trex_gui.devices.trex.recording.recording.Writer`."""

    size: int

    def write(self, records: Sequence[WrittenT_contra]) -> None:
        """Take records."""

    def flush(self) -> None:
        """Put what was taken into the file."""

    def finish(self) -> None:
        """Make the file complete."""


class RecordWorker(WorkerThread, Generic[RecordT]):
    """Writes one recording; ends when its backlog is closed, or when the disk refuses.

    Signals:
        progressed: bytes written so far.
        failed: why the recording has ended before it should, for people.
    """

    progressed = Signal(object)
    failed = Signal(str)

    def __init__(
        self,
        path: Path,
        begun: float,
        backlog: Backlog[RecordT],
        writer_of: Callable[[BinaryIO], Writer[RecordT | Marker]],
        parent: QObject | None = None,
    ) -> None:
        """Write into `path` what `writer_of` makes of the records.

        `begun` is when it begins, on the session's clock; `writer_of` is called in the new thread.
        """
        super().__init__(parent)
        self.setObjectName("RecordWorker")
        self._path = path
        self._begun = begun
        self._backlog = backlog
        self._writer_of = writer_of

    def run(self) -> None:
        """Write until the end; called by Qt in the new thread."""
        try:
            with self._path.open("wb") as file:
                self._write(file)
        except (OSError, ValueError) as error:
            self._fail(getattr(error, "strerror", None) or error)
        except Exception as error:
            log.exception("a recording")
            self._fail(self.tr("a fault of the program ({0})").format(type(error).__name__))

    def _fail(self, reason: object) -> None:
        self._backlog.close(self._begun)
        self.failed.emit(self.tr("{0} cannot be written: {1}.").format(self._path, reason))

    def _write(self, file: BinaryIO) -> None:
        writer = self._writer_of(file)
        safe_at = now() + _SAFE
        self.progressed.emit(writer.size)
        while (records := self._backlog.get(_LOOK)) is not None:
            writer.write(records)
            moment = now()
            if moment >= safe_at:
                safe_at = moment + _SAFE
                _save(writer, file)
            self.progressed.emit(writer.size)
        writer.finish()
        _sync(file)
        self.progressed.emit(writer.size)


def _save(writer: Writer[WrittenT_contra], file: BinaryIO) -> None:
    writer.flush()
    file.flush()
    _sync(file)


def _sync(file: BinaryIO) -> None:
    """Bring a file down to the disk, where it is one: a pipe has none."""
    with contextlib.suppress(OSError):
        os.fsync(file.fileno())
