"""Recording what a board reports and what is asked of it, while it happens."""

import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.link.drives import wishes_in
from trex_gui.link.messages import Batch, MotorRequest
from trex_gui.link.reading import DeviceState
from trex_gui.model.device import Device, Link
from trex_gui.model.events import Event
from trex_gui.recording.backlog import Backlog
from trex_gui.recording.files import writer_for
from trex_gui.recording.recording import Record
from trex_gui.recording.recording_of import header_of, marker, settings_seen, wish_of
from trex_gui.worker.record_worker import RecordWorker

_PATIENCE_MS = 3000
"""How long the end of the program waits for a disk."""

_abandoned: list[RecordWorker[Record]] = []
"""Threads that a disk holds up at the end of the program: a `QThread` must outlive its run."""


class Recorder(QObject):
    """Writes the session of a device into one file at a time.

    A recording ends with the connection, and where the board comes back as another one or with
    other inputs: its header would be wrong. While the board is only silent it goes on.

    Signals:
        changed: whether something is recorded, its size.
        ended: a recording is complete; its `Path`.
        told: why a recording has ended though nobody ended it, for people.
        failed: why it cannot be written, for people.
    """

    changed = Signal()
    ended = Signal(object)
    told = Signal(str)
    failed = Signal(str)

    def __init__(
        self,
        device: Device,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Record nothing yet; `clock` is the session's, which is the computer's monotonic one."""
        super().__init__(parent)
        self._device = device
        self._clock = clock
        self._worker: RecordWorker[Record] | None = None
        self._backlog: Backlog[Record] = Backlog()
        self._path: Path | None = None
        self._begun = 0.0
        self._size = 0
        self._lost = 0
        self._closing = False
        self._refused = False
        self._board: tuple[object, ...] = ()
        self._settings = ""

        device.sampled.connect(self._on_sampled)
        device.events.happened.connect(self._on_happened)
        device.motors.requested.connect(self._on_requested)
        device.state_changed.connect(self._on_state_changed)
        device.link_changed.connect(self._on_link_changed)

    # --- What is known ------------------------------------------------------------------

    @property
    def can_record(self) -> bool:
        """Whether there is a board to record, and nothing is being recorded."""
        is_up = self._device.link is Link.UP and self._device.state is not None
        return is_up and self._worker is None

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
        return self._clock() - self._begun if self.recording else 0.0

    @property
    def size(self) -> int:
        """Bytes written so far; what waits is not counted."""
        return self._size

    @property
    def lost(self) -> int:
        """Samples that could not be recorded because the disk was too slow."""
        return self._backlog.lost

    # --- What a person does -------------------------------------------------------------

    def start(self, path: Path) -> bool:
        """Record into a file from now on; return whether that is possible now.

        The format follows from the suffix: `.csv`, or `.trexrec` for anything else. A file of
        that name is replaced.
        """
        state = self._device.state
        if state is None or not self.can_record:
            return False
        settings = self._device.settings
        self._begun = self._clock()
        number = settings.device_number if settings is not None else None
        header = header_of(state, self._begun, number)
        self._path, self._size, self._closing, self._refused = path, 0, False, False
        self._board, self._settings = _identity(state), header.settings
        self._backlog = Backlog()
        writer_of = partial(writer_for, path, header=header)
        worker = RecordWorker(path, self._begun, self._backlog, writer_of, self)
        worker.progressed.connect(self._on_progressed)
        worker.failed.connect(self._on_failed)
        worker.finished.connect(self._on_finished)
        self._worker = worker
        worker.start()
        self.changed.emit()
        return True

    @Slot()
    def stop(self) -> None:
        """End the recording; `ended` follows when its last byte is written."""
        if self.recording:
            self._closing = True
            self._backlog.close(self._clock())
            self.changed.emit()

    def shut_down(self) -> bool:
        """End the recording and wait for it a little; for the end of the program.

        Return whether its thread has ended. While it has not, the process must not end by
        itself: Qt aborts on destroying a thread that runs.
        """
        self.stop()
        worker = self._worker
        if worker is None:
            return True
        if worker in _abandoned:
            return worker.isFinished()
        if worker.wait(_PATIENCE_MS):
            return True
        worker.setParent(None)
        _abandoned.append(worker)
        return False

    # --- What is recorded ---------------------------------------------------------------

    def _put(self, *records: Record) -> None:
        if self.recording:
            self._backlog.put(records)
            if self._backlog.lost != self._lost:
                self._lost = self._backlog.lost
                self.changed.emit()

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        self._put(*batch.samples)

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        self._put(marker(event.time, event.kind.value, event.text))

    @Slot(object)
    def _on_requested(self, request: MotorRequest) -> None:
        now = self._clock()
        self._put(*(wish_of(wish, now) for wish in wishes_in(request)))

    @Slot()
    def _on_state_changed(self) -> None:
        state = self._device.state
        if state is None or not self.recording:
            return
        if _identity(state) != self._board:
            self.stop()
            self.told.emit(
                self.tr(
                    "The recording {0} has ended: the board is another one, or its mode."
                ).format(self._path)
            )
            return
        seen = settings_seen(state, self._clock())
        if seen.text != self._settings:
            self._settings = seen.text
            self._put(seen)

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._device.link is Link.NONE:
            self.stop()
            text = self.tr("The recording {0} has ended with the connection.")
            self.told.emit(text.format(self._path))
        self.changed.emit()

    # --- The thread that writes ---------------------------------------------------------

    @Slot(object)
    def _on_progressed(self, size: int) -> None:
        self._size = size
        self.changed.emit()

    @Slot(str)
    def _on_failed(self, text: str) -> None:
        self._closing = self._refused = True
        self.failed.emit(text)

    @Slot()
    def _on_finished(self) -> None:
        worker, self._worker = self._worker, None
        if worker is not None:
            worker.deleteLater()
        self.changed.emit()
        if not self._refused:
            self.ended.emit(self._path)


def _identity(state: DeviceState) -> tuple[object, ...]:
    """What a recording's header says of a board and what stays so."""
    return state.signature, state.source
