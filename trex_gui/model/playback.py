"""A recording that is looked at: its curves, its events, and what was known at one time."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal, Slot

from trex_gui.model.events import Event
from trex_gui.model.recorded import MOST_ROWS, Recorded, gather
from trex_gui.model.telemetry import Series
from trex_gui.model.trace.board import board_traces
from trex_gui.model.trace.history import History
from trex_gui.model.trace.traces import Traces
from trex_gui.recording.errors import RecordingError
from trex_gui.recording.files import open_recording
from trex_gui.recording.recording import Header, RecordingFile
from trex_gui.recording.replay import Latest, Replay, export_span
from trex_gui.settings.errors import SettingsError
from trex_gui.settings.reader import read_settings
from trex_gui.worker.file_worker import Done, FileWorker, Tell

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""How many times as fast as it happened a recording can be played."""

_FRAME_MS = 33

_PATIENCE_MS = 500
"""How long closing waits for a disk; armed motors are stopped when a window is silent for twice
as long."""

_abandoned: list[FileWorker] = []
"""Threads that a disk holds up: a `QThread` must outlive its run."""


class Playback(QObject):
    """One recording, read by a thread of its own, and a place in it that can be moved and played.

    Before it is loaded only its header is known: there are no curves, events and blocks.

    Signals:
        progressed: `progress` or `exporting`.
        loaded: all of it was read; `traces`, `events`, `end` and `problems`.
        moved: `position`.
        playing_changed: `playing` or `speed`.
        exported: a span was written; its `Path`.
        failed: why reading or exporting has ended, for people.
    """

    progressed = Signal()
    loaded = Signal()
    moved = Signal()
    playing_changed = Signal()
    exported = Signal(object)
    failed = Signal(str)

    def __init__(
        self,
        file: RecordingFile,
        path: Path,
        parent: QObject | None = None,
        *,
        most_rows: int = MOST_ROWS,
    ) -> None:
        """Take a recording of which only the head was read, and `start_reading` the rest.

        Of its samples the last `most_rows` are drawn.
        """
        super().__init__(parent)
        self.path = path
        self._file = file
        self._most_rows = most_rows
        self._replay: Replay | None = None
        self._events: Sequence[Event] = ()
        self._limits = limits_in(file.header.settings)
        self._rows = 0
        self._history = History(len(Series), capacity=4096)
        self.traces = Traces(board_traces(), self._history)
        self._end = file.header.clock
        self._position = file.header.clock
        self._speed = 1.0
        self._progress = 0.0
        self._worker: FileWorker | None = None
        self._export_path: Path | None = None
        self._export_share = 0.0
        self._playing = QTimer(self)
        self._playing.setInterval(_FRAME_MS)
        self._since = QElapsedTimer()

        self._playing.timeout.connect(self._on_frame)

    @classmethod
    def open(cls, path: Path, parent: QObject | None = None) -> "Playback":
        """Open a recording and begin to read it.

        Raises:
            RecordingError: there is none that can be read.
        """
        playback = cls(open_recording(path, head_only=True), path, parent)
        playback.start_reading()
        return playback

    def close(self) -> bool:
        """Give up what is read or written, and give the file back; nothing more can be asked.

        Return whether its thread has ended. While it has not, the process must not end by
        itself: Qt aborts on destroying a thread that runs.
        """
        self._playing.stop()
        worker, self._worker = self._worker, None
        self._export_path = None
        if worker is not None:
            if not worker.close(_PATIENCE_MS):
                worker.setParent(None)
                _abandoned.append(worker)
                return False  # the file is still that thread's
            worker.deleteLater()
        if any(not worker.isFinished() for worker in _abandoned):
            return False
        self._file.close()
        return True

    # --- What is known ------------------------------------------------------------------

    @property
    def header(self) -> Header:
        """Of what the recording is."""
        return self._file.header

    @property
    def problems(self) -> Sequence[str]:
        """What is missing of it, as sentences."""
        return self._file.problems if self.is_loaded else ()

    @property
    def progress(self) -> float:
        """How much of it was read, 0 to 1."""
        return 1.0 if self.is_loaded else self._progress

    @property
    def is_loaded(self) -> bool:
        """Whether all of it was read."""
        return self._replay is not None

    @property
    def drawn(self) -> tuple[int, int]:
        """How many samples of the currents are drawn, and how many there are."""
        return len(self._history), self._rows

    @property
    def events(self) -> Sequence[Event]:
        """What happened, in the order of time."""
        return self._events

    @property
    def start(self) -> float:
        """When it begins on the session's clock."""
        return self.header.clock

    @property
    def end(self) -> float:
        """When it ends on the session's clock; when it begins, before it is loaded."""
        return self._end

    @property
    def position(self) -> float:
        """The place that is looked at, on the session's clock."""
        return self._position

    @property
    def playing(self) -> bool:
        """Whether the place moves by itself."""
        return self._playing.isActive()

    @property
    def speed(self) -> float:
        """How many times as fast as it happened it plays."""
        return self._speed

    @property
    def busy(self) -> bool:
        """Whether it is read or exported."""
        return self._worker is not None

    @property
    def exporting(self) -> float | None:
        """How much of an export is done, 0 to 1; `None` while there is none."""
        return self._export_share if self._export_path is not None else None

    def latest(self) -> Latest:
        """Return what was known at the position."""
        if self._replay is not None:
            try:
                return self._replay.at(self._position)
            except RecordingError as error:
                self.failed.emit(str(error))
        return Latest(self.header.mode, self.header.settings)

    # --- What a person does -------------------------------------------------------------

    def set_position(self, time: float) -> None:
        """Look at a time of the session's clock, or at the nearest that was recorded."""
        time = max(self.start, min(self._end, time))
        if time != self._position:
            self._position = time
            self.moved.emit()

    def play(self) -> None:
        """Let the place move; from the start again when it is at the end."""
        if self._position >= self._end:
            self.set_position(self.start)
        self._since.start()
        self._playing.start()
        self.playing_changed.emit()

    def pause(self) -> None:
        """Let the place stand."""
        if self._playing.isActive():
            self._playing.stop()
            self.playing_changed.emit()

    def set_speed(self, speed: float) -> None:
        """Play so many times as fast as it happened."""
        if speed <= 0:
            raise ValueError(f"a recording cannot be played {speed} times as fast")
        self._speed = speed
        self.playing_changed.emit()

    def advance(self, seconds: float) -> None:
        """Let so many seconds pass for whoever watches."""
        self.set_position(self._position + seconds * self._speed)
        if self._position >= self._end and self.is_loaded:
            self.pause()

    def export(self, path: Path, start: float, end: float) -> None:
        """Write a span as CSV; ends in `exported` or `failed`, unless it is cancelled."""
        if self._worker is not None or not self.is_loaded:
            return
        self._export_path, self._export_share = path, 0.0
        file = self._file

        def work(tell: Tell) -> None:
            own = file.again()  # this one goes on showing values
            try:
                export_span(own, path, start, end, tell)
            finally:
                own.close()

        self._begin(work)

    def cancel_export(self) -> None:
        """Write no further; whatever had the name of the file before is still there."""
        if self._worker is not None and self._export_path is not None:
            self._worker.cancel()

    def start_reading(self) -> None:
        """Read it while the window lives on."""
        self._begin(partial(gather, self._file, most_rows=self._most_rows))

    # --- The thread ---------------------------------------------------------------------

    def _begin(self, work: Callable[[Tell], object]) -> None:
        worker = FileWorker(work, self)
        worker.progressed.connect(self._on_progressed)
        worker.done.connect(self._on_done)
        worker.finished.connect(self._on_finished)
        self._worker = worker
        worker.start(FileWorker.Priority.LowPriority)

    @Slot(float)
    def _on_progressed(self, share: float) -> None:
        if self._export_path is not None:
            self._export_share = share
        else:
            self._progress = share
        self.progressed.emit()

    @Slot(object)
    def _on_done(self, done: Done) -> None:
        if self._worker is None:  # closed meanwhile
            return
        self._let_go()
        path, self._export_path = self._export_path, None
        if done.error is not None:
            self.failed.emit(str(done.error))
        elif isinstance(done.result, Recorded):
            self._take(done.result)
        elif path is not None:
            self.exported.emit(path)

    @Slot()
    def _on_finished(self) -> None:
        """It was cancelled: else it told what came of it, and was let go then."""
        if self._worker is not None and self._worker.isFinished():
            self._let_go()
            self._export_path = None
            self.progressed.emit()

    def _let_go(self) -> None:
        """Forget a thread that is at its end."""
        worker, self._worker = self._worker, None
        if worker is not None:
            worker.wait()
            worker.deleteLater()

    def _take(self, recorded: Recorded) -> None:
        self._replay = recorded.replay
        self._history, self._rows = recorded.history, recorded.rows
        self._events = recorded.events
        self.traces = Traces(board_traces(), self._history, self._events, self._limits)
        self._end = recorded.end
        self.progressed.emit()
        self.loaded.emit()

    @Slot()
    def _on_frame(self) -> None:
        self.advance(self._since.restart() / 1000)


def limits_in(text: str) -> Mapping[str, float]:
    """Return the current limits (A) that settings hold, by the name of the curve."""
    try:
        settings, _ = read_settings(text.encode("utf-8"), "settings")
    except (SettingsError, UnicodeError):
        return {}
    limits = {}
    for motor in (1, 2):
        key = f"motor{motor}_current_limit"
        if wire := settings.parameters.get(key):
            limits[f"motor{motor}_current"] = wire * settings.specs[key].scale
    return limits
