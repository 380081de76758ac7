"""Recording what a robot reports and what is asked of it, while it happens."""

import time
from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.aracna.link.messages import Moved, Moving, Passed, SpeedsHeld, StepBegun
from trex_gui.aracna.model.robot import Robot
from trex_gui.aracna.recording import CsvWriter, Header, Row
from trex_gui.model.connection import Link
from trex_gui.model.events import Event
from trex_gui.recording.backlog import Backlog
from trex_gui.recording.recording_of import marker
from trex_gui.worker.record_worker import RecordWorker

_PATIENCE_MS = 3000
"""How long the end of the program waits for a disk."""

_abandoned: list[RecordWorker[Row]] = []
"""Threads that a disk holds up at the end of the program: a `QThread` must outlive its run."""


class AracnaRecorder(QObject):
    """Writes the session of a robot into one CSV file at a time.

    A recording ends with the connection, and where the robot comes back with another number of
    motors: its columns would be wrong. While the robot is only silent it goes on.

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
        robot: Robot,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Record nothing yet; `clock` is the session's."""
        super().__init__(parent)
        self._robot = robot
        self._clock = clock
        self._worker: RecordWorker[Row] | None = None
        self._backlog: Backlog[Row] = Backlog()
        self._path: Path | None = None
        self._begun = 0.0
        self._size = 0
        self._lost = 0
        self._motors = 0
        self._closing = False
        self._refused = False

        robot.reported.connect(self._on_reported)
        robot.events.happened.connect(self._on_happened)
        robot.link_changed.connect(self._on_link_changed)

    # --- What is known ------------------------------------------------------------------

    @property
    def can_record(self) -> bool:
        """Whether there is a robot to record, and nothing is being recorded."""
        return self._robot.link is Link.UP and self._worker is None

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
        """Records that could not be kept because the disk was too slow."""
        return self._backlog.lost

    # --- What a person does -------------------------------------------------------------

    def start(self, path: Path) -> bool:
        """Record into a CSV file from now on; return whether that is possible now.

        A file of that name is replaced.
        """
        if not self.can_record:
            return False
        self._begun = self._clock()
        self._motors = self._robot.motors
        header = Header(datetime.now(UTC), self._begun, self._robot.version or 0, self._motors)
        self._path, self._size, self._lost = path, 0, 0
        self._closing = self._refused = False
        self._backlog = Backlog()
        writer_of = partial(CsvWriter, header=header)
        worker = RecordWorker(path, self._begun, self._backlog, writer_of, self)
        worker.progressed.connect(self._on_progressed)
        worker.failed.connect(self._on_failed)
        worker.finished.connect(self._on_finished)
        self._worker = worker
        self._put_what_is_known()
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

    def _put(self, *records: Row) -> None:
        if self.recording:
            self._backlog.put(records)
            if self._backlog.lost != self._lost:
                self._lost = self._backlog.lost
                self.changed.emit()

    def _put_what_is_known(self) -> None:
        """Begin with where the motors are and which speeds they hold, as far as that is known."""
        known, now = self._robot.known, self._begun
        if any(place is not None for place in known.present):
            places = tuple(-1 if place is None else place for place in known.present)
            self._put(Passed(now, places))
        if known.speeds is not None:
            self._put(SpeedsHeld(now, known.speeds.wanted, known.speeds.held))

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        if isinstance(report, Moving | Passed | Moved | SpeedsHeld | StepBegun):
            self._put(report)

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        self._put(marker(event.time, event.kind.value, event.text))

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._robot.link is Link.NONE:
            self._end(self.tr("The recording {0} has ended with the connection."))
        elif self.recording and self._robot.motors != self._motors:
            self._end(self.tr("The recording {0} has ended: the robot has other motors."))
        else:
            self.changed.emit()

    def _end(self, words: str) -> None:
        self.stop()
        self.told.emit(words.format(self._path))

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
