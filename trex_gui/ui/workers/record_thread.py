"""Recording in a separate thread, independent of the line and the window."""

import logging
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Generic

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.events import Event
from trex_gui.core.recording.backlog import Backlog
from trex_gui.core.recording.kinds import (
    HeaderT,
    Marker,
    RecordingError,
    RecordingFormat,
    RecordT,
    marker,
)
from trex_gui.core.recording.store import RecordingWriter
from trex_gui.core.translation import tr
from trex_gui.ui.runtime import now, runtime
from trex_gui.ui.workers.threads import WorkerThread, adopt_orphan, release_orphan

log = logging.getLogger(__name__)

_COMMIT_INTERVAL = 0.5  # seconds; limits the loss in a crash
_SYNC_INTERVAL = 5.0  # seconds; limits the loss in a power failure
_SHUTDOWN_TIMEOUT_MS = 3000


class RecordWorker(WorkerThread, Generic[RecordT]):
    progressed = Signal(object)  # number of bytes written

    def __init__(
        self,
        backlog: Backlog[RecordT],
        open_writer: Callable[[], RecordingWriter[Any, RecordT]],
        parent: QObject | None = None,
    ) -> None:
        """`open_writer`: called in the new thread."""
        super().__init__(parent)
        self.setObjectName("RecordWorker")
        self.error = ""  # for the user; set before the thread ends
        self._backlog = backlog
        self._open_writer = open_writer

    def run(self) -> None:
        try:
            writer = self._open_writer()
            try:
                self._write(writer)
            finally:
                writer.close()
        except RecordingError as error:
            self.error = str(error)
        except Exception as error:
            log.exception("Internal error while recording")
            text = tr("Internal error while recording ({0}). The recording has ended.")
            self.error = text.format(type(error).__name__)
        finally:
            self._backlog.close(0.0)

    def _write(self, writer: RecordingWriter[Any, RecordT]) -> None:
        self.progressed.emit(writer.size)
        commit_at = now() + _COMMIT_INTERVAL
        sync_at = now() + _SYNC_INTERVAL
        while (records := self._backlog.get(_COMMIT_INTERVAL)) is not None:
            writer.write(records)
            moment = now()
            if moment >= sync_at:
                sync_at = moment + _SYNC_INTERVAL
                writer.sync()
            elif moment >= commit_at:
                commit_at = moment + _COMMIT_INTERVAL
                writer.commit()
            self.progressed.emit(writer.size)
        writer.finish()
        self.progressed.emit(writer.size)


class RecordThread(QObject, Generic[RecordT]):
    """Recorder that writes the records of one device to one file at a time.

    A subclass defines `is_available`, calls `start_recording` and passes records to `put`.
    """

    changed = Signal()  # `recording`, `can_record`, `size` or `lost` has changed
    ended = Signal(object)  # the `Path` of a complete recording
    ended_early = Signal(str)  # the reason, for the user
    failed = Signal(str)  # the write error, for the user

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.path: Path | None = None  # the current or the last file
        self.size = 0  # number of bytes written
        self._worker: RecordWorker[RecordT] | None = None
        self._backlog: Backlog[RecordT] = Backlog(runtime().condition())
        self._started = 0.0
        self._closing = False
        self._abandoned = False  # `shut_down` has timed out and will not wait again

    @property
    def is_available(self) -> bool:
        raise NotImplementedError

    @property
    def can_record(self) -> bool:
        return self._worker is None and self.is_available

    @property
    def recording(self) -> bool:
        return self._worker is not None and not self._closing

    @property
    def seconds(self) -> float:
        return now() - self._started if self.recording else 0.0

    @property
    def lost(self) -> int:
        return self._backlog.lost

    def start(self, path: Path) -> bool:
        raise NotImplementedError

    def start_recording(
        self,
        path: Path,
        fmt: RecordingFormat[HeaderT],
        header: HeaderT,
        first: Sequence[RecordT | Marker] = (),
        prepare: Callable[[], object] = lambda: None,
    ) -> None:
        """Record into a new file.

        `first`: records at the start of the file. `prepare`: called first, in the new thread.
        """

        def open_writer() -> RecordingWriter[HeaderT, RecordT]:
            prepare()
            return RecordingWriter(path, fmt, header)

        self.path, self._started = path, header.clock
        self.size = 0
        self._closing = self._abandoned = False
        self._backlog = Backlog(runtime().condition())
        worker = RecordWorker(self._backlog, open_writer, self)
        worker.progressed.connect(self._on_progressed, Qt.ConnectionType.QueuedConnection)
        worker.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)
        self._worker = worker
        self._backlog.put(first)
        worker.start()
        self.changed.emit()

    @Slot(object)
    def put_event(self, event: Event) -> None:
        self.put(marker(event.time, event.kind.value, event.text))

    def put(self, *records: RecordT | Marker) -> None:
        if self.recording:
            before = self.lost
            self._backlog.put(records)
            if self.lost != before:
                self.changed.emit()

    @Slot()
    def stop(self) -> None:
        """End the recording. `ended` is emitted once the file is complete."""
        if self.recording:
            self._closing = True
            self._backlog.close(now())
            self.changed.emit()

    def stop_early(self, message: str) -> None:
        """End the recording and report the reason. `{0}` in the message becomes the path."""
        self.stop()
        self.ended_early.emit(message.format(self.path))

    def shut_down(self) -> bool:
        """End the recording. Return whether its thread has ended in time."""
        self.stop()
        worker = self._worker
        timeout_ms = 0 if self._abandoned else _SHUTDOWN_TIMEOUT_MS
        if worker is None or worker.wait(timeout_ms):
            return True
        self._abandoned = True
        adopt_orphan(worker)
        return False

    @Slot(object)
    def _on_progressed(self, size: int) -> None:
        self.size = size
        self.changed.emit()

    @Slot()
    def _on_finished(self) -> None:
        worker, self._worker = self._worker, None
        if worker is None:
            return
        release_orphan(worker)
        worker.deleteLater()
        self.changed.emit()
        if worker.error:
            self.failed.emit(worker.error)
        else:
            self.ended.emit(self.path)
