"""Recording what a device reports while it happens: the life of the thread that writes."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import BinaryIO, Generic

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.recording.backlog import Backlog
from trex_gui.core.recording.blocks import RecordT
from trex_gui.devices.trex.recording.recording import Marker
from trex_gui.ui.runtime import now, runtime
from trex_gui.ui.workers import orphaned_threads
from trex_gui.ui.workers.record_worker import RecordWorker, Writer

_PATIENCE_MS = 3000
"""How long the end of the program waits for a disk."""


class RecordThread(QObject, Generic[RecordT]):
    """Writes what it is given into one file at a time, whatever the device.

    One for each device derives from it: it says whether there is something to record, begins with
    `begin` and hands on with `put` what is to be kept.

    Signals:
        changed: whether something is recorded, its size.
        ended: a recording is complete; its `Path`.
        ended_early: why a recording has ended although the user did not end it, as a sentence.
        failed: why it cannot be written, for people.
    """

    changed = Signal()
    ended = Signal(object)
    ended_early = Signal(str)
    failed = Signal(str)

    def __init__(self, parent: QObject | None = None, *, clock: Callable[[], float] = now) -> None:
        """Record nothing yet; `clock` is the session's, which is the computer's monotonic one."""
        super().__init__(parent)
        self.clock = clock
        self._worker: RecordWorker[RecordT] | None = None
        self._backlog: Backlog[RecordT] = Backlog(runtime().condition())
        self._path: Path | None = None
        self._begun = 0.0
        self._size = 0
        self._lost = 0
        self._closing = False
        self._refused = False
        self._given_up = False  # at the end of the program, which waits once

    # --- What is known ------------------------------------------------------------------

    @property
    def is_there(self) -> bool:
        """Whether there is a device to record."""
        raise NotImplementedError

    @property
    def can_record(self) -> bool:
        """Whether there is a device to record, and nothing is being recorded."""
        return self._worker is None and self.is_there

    @property
    def recording(self) -> bool:
        """Whether what comes is recorded."""
        return self._worker is not None and not self._closing

    @property
    def path(self) -> Path | None:
        """The file that is written, or was written last."""
        return self._path

    @property
    def seconds(self) -> float:
        """How long it has been recording."""
        return self.clock() - self._begun if self.recording else 0.0

    @property
    def size(self) -> int:
        """Bytes written so far; what waits is not counted."""
        return self._size

    @property
    def lost(self) -> int:
        """Records that could not be kept because the disk was too slow."""
        return self._backlog.lost

    # --- Beginning and ending -----------------------------------------------------------

    def start(self, path: Path) -> bool:
        """Record into a file from now on; return whether that is possible now."""
        raise NotImplementedError

    def begin(
        self,
        path: Path,
        begun: float,
        writer_of: Callable[[BinaryIO], Writer[RecordT | Marker]],
        first: Sequence[RecordT] = (),
    ) -> None:
        """Record into a file from now on; one of that name is replaced.

        `begun` is now on the session's clock; `writer_of` makes the writer, in the thread;
        `first` are the records that it begins with.
        """
        self._path, self._begun = path, begun
        self._size = self._lost = 0
        self._closing = self._refused = self._given_up = False
        self._backlog = Backlog(runtime().condition())
        worker = RecordWorker(path, begun, self._backlog, writer_of, self)
        worker.progressed.connect(self._on_progressed, Qt.ConnectionType.QueuedConnection)
        worker.failed.connect(self._on_failed, Qt.ConnectionType.QueuedConnection)
        worker.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)
        self._worker = worker
        self.put(*first)
        worker.start()
        self.changed.emit()

    def put(self, *records: RecordT) -> None:
        """Keep records, where something is recorded."""
        if self.recording:
            self._backlog.put(records)
            if self._backlog.lost != self._lost:
                self._lost = self._backlog.lost
                self.changed.emit()

    @Slot()
    def stop(self) -> None:
        """End the recording; `ended` follows when its last byte is written."""
        if self.recording:
            self._closing = True
            self._backlog.close(self.clock())
            self.changed.emit()

    def end_because(self, words: str) -> None:
        """End the recording and tell why; `{0}` in the words is its file."""
        self.stop()
        self.ended_early.emit(words.format(self._path))

    def shut_down(self) -> bool:
        """End the recording and wait for it a little; for the end of the program.

        Return whether its thread has ended. While it has not, the process must not end by
        itself: Qt aborts on destroying a thread that runs.
        """
        self.stop()
        worker = self._worker
        if worker is None:
            return True
        if worker.wait(0 if self._given_up else _PATIENCE_MS):
            return True
        self._given_up = True
        orphaned_threads.adopt(worker)
        return False

    # --- The thread that writes ---------------------------------------------------------

    @Slot(object)
    def _on_progressed(self, size: int) -> None:
        self._size = size
        self.changed.emit()

    @Slot(str)
    def _on_failed(self, text: str) -> None:
        self._closing = self._refused = True
        self.changed.emit()
        self.failed.emit(text)

    @Slot()
    def _on_finished(self) -> None:
        worker, self._worker = self._worker, None
        if worker is not None:
            orphaned_threads.release(worker)
            worker.deleteLater()
        self.changed.emit()
        if not self._refused:
            self.ended.emit(self._path)
