"""A recording of anything that is looked at: a thread reads it, and what was known is found."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Generic

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.recording.block_replay import BlockReplay, LatestT
from trex_gui.core.recording.blocks import BlockFile, HeaderT, RecordT
from trex_gui.core.recording.errors import RecordingError
from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.playback.cursor import PlaybackCursor
from trex_gui.ui.playback.recording_loader import LoadedRecording
from trex_gui.ui.plotting.data.history import SampleHistory
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.workers import orphaned_threads
from trex_gui.ui.workers.file_worker import Done, FileWorker, ProgressCallback

_PATIENCE_MS = 500
"""How long closing waits for a disk; armed motors are stopped when a window is silent for twice
as long."""


class RecordingPlayer(PlaybackCursor, Generic[HeaderT, RecordT, LatestT]):
    """One recording, read by a thread of its own, and a place in it that can be moved and played.

    Before it is loaded only its header is known: there are no curves, events and blocks. One for
    each device derives from it and says what is gathered and drawn of its recordings.

    Signals:
        progressed: `progress`, or how far anything else is that is done with the file.
        loaded: all of it was read; `traces`, `events`, `end` and `problems`.
        failed: why reading, or what else is done with the file, has ended, for people.
    """

    loaded = Signal()
    failed = Signal(str)

    def __init__(
        self,
        file: BlockFile[HeaderT, RecordT],
        path: Path,
        parent: QObject | None = None,
        *,
        columns: int,
    ) -> None:
        """Take a recording of which only the head was read, and `start_reading` the rest.

        It has so many curves.
        """
        super().__init__(file.header.clock, parent)
        self.path = path
        self._blocks = file
        self._replay: BlockReplay[RecordT, LatestT] | None = None
        self._events: Sequence[Event] = ()
        self._rows = 0
        self._history = SampleHistory(columns, capacity=4096)
        self._progress = 0.0
        self._worker: FileWorker | None = None
        self._given_up: FileWorker | None = None  # a disk held it up when this was closed
        self._traces: Traces | None = None

    # --- What the recordings of a device are -------------------------------------------

    def loader(
        self,
    ) -> Callable[[ProgressCallback], LoadedRecording[BlockReplay[RecordT, LatestT]]]:
        """Return what reads all of it, in another thread; it must not hold on to this object."""
        raise NotImplementedError

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        """Return the curves of what was gathered."""
        raise NotImplementedError

    def first(self) -> LatestT:
        """Return what is known before the first record."""
        raise NotImplementedError

    # --- The end ------------------------------------------------------------------------

    def close(self) -> bool:
        """Give up what is read or written, and give the file back; nothing more can be asked.

        Return whether its thread has ended. While it has not, the process must not end by
        itself: Qt aborts on destroying a thread that runs.
        """
        self.pause()
        worker, self._worker = self._worker, None
        if worker is not None:
            if not worker.close(_PATIENCE_MS):
                orphaned_threads.adopt(worker)
                self._given_up = worker
            else:
                worker.deleteLater()
        if self._given_up is not None:
            if not self._given_up.wait(0):
                return False  # the file is still that thread's
            self._given_up = None
        self._blocks.close()
        return True

    # --- What is known ------------------------------------------------------------------

    @property
    def header(self) -> HeaderT:
        """Of what the recording is."""
        return self._blocks.header

    @property
    def problems(self) -> Sequence[str]:
        """What is missing of it, as sentences."""
        return self._blocks.problems if self.is_loaded else ()

    @property
    def progress(self) -> float:
        """How much of it was read, 0 to 1."""
        return 1.0 if self.is_loaded else self._progress

    @property
    def is_loaded(self) -> bool:
        """Whether all of it was read."""
        return self._replay is not None

    @property
    def working(self) -> float | None:
        """The share that is done of what is done with the file, 0 to 1; `None`: nothing is."""
        return self._progress if self.busy and not self.is_loaded else None

    @property
    def traces(self) -> Traces:
        """The curves, and the events between them."""
        if self._traces is None:
            self._traces = self.traces_of(self._history, self._events)
        return self._traces

    @property
    def drawn(self) -> tuple[int, int]:
        """How many samples are drawn, and how many there are."""
        return len(self._history), self._rows

    @property
    def events(self) -> Sequence[Event]:
        """What happened, in the order of time."""
        return self._events

    @property
    def busy(self) -> bool:
        """Whether something is done with the file."""
        return self._worker is not None

    def latest(self) -> LatestT:
        """Return what was known at the position."""
        if self._replay is not None:
            try:
                return self._replay.at(self._position)
            except RecordingError as error:
                self.failed.emit(str(error))
        return self.first()

    # --- What a person does -------------------------------------------------------------

    def cancel_work(self) -> None:
        """Go no further with what is done with the file."""
        if self._worker is not None:
            self._worker.cancel()

    def start_reading(self) -> None:
        """Read it while the window lives on."""
        self.begin(self.loader())

    # --- The thread ---------------------------------------------------------------------

    def begin(self, work: Callable[[ProgressCallback], object]) -> None:
        """Do something with the file in a thread; `end_with` follows unless it is cancelled."""
        worker = FileWorker(work, self)
        worker.progressed.connect(self._on_progressed, Qt.ConnectionType.QueuedConnection)
        worker.done.connect(self._on_done, Qt.ConnectionType.QueuedConnection)
        worker.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)
        self._worker = worker
        worker.start(FileWorker.Priority.LowPriority)

    def note_share(self, share: float) -> None:
        """Take how far the work is, 0 to 1."""
        self._progress = share

    def end_with(self, result: object) -> None:
        """Take the result of the work: an error where it failed, `None` where it was cancelled."""
        if isinstance(result, LoadedRecording):
            self._take(result)

    @Slot(float)
    def _on_progressed(self, share: float) -> None:
        self.note_share(share)
        self.progressed.emit()

    @Slot(object)
    def _on_done(self, done: Done) -> None:
        if self._worker is None:  # closed meanwhile
            return
        self._let_go()
        if done.error is not None:
            self.end_with(done.error)
            self.failed.emit(str(done.error))
        else:
            self.end_with(done.result)

    @Slot()
    def _on_finished(self) -> None:
        """It was cancelled: else it told what came of it, and was let go then."""
        if self._worker is not None and self.sender() is self._worker:
            self._let_go()
            self.end_with(None)
            self.progressed.emit()

    def _let_go(self) -> None:
        """Forget a thread that is at its end."""
        worker, self._worker = self._worker, None
        if worker is not None:
            worker.wait()
            worker.deleteLater()

    def _take(self, gathered: LoadedRecording[BlockReplay[RecordT, LatestT]]) -> None:
        self._replay = gathered.replay
        self._history, self._rows = gathered.history, gathered.rows
        self._events = gathered.events
        self._traces = None
        self._end = gathered.end
        self.progressed.emit()
        self.loaded.emit()
