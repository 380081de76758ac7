"""Playback of a recording that a thread loads."""

from collections.abc import Callable, Iterable, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from operator import attrgetter
from pathlib import Path
from typing import Any, Generic

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.events import Event, EventKind
from trex_gui.core.recording.export import export_span
from trex_gui.core.recording.kinds import HeaderT, Marker, RecordingError, RecordT, Value
from trex_gui.core.recording.replay import Replay, StateT
from trex_gui.core.recording.store import Recording
from trex_gui.core.timing import FRAME_MS
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.traces import Traces
from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.workers.file_worker import Done, FileTask, ProgressCallback

_MAX_EVENT_LENGTH = 500  # characters
_CLOSE_TIMEOUT_MS = 500  # below `Timeouts.heartbeat`, since a late heartbeat stops the motors


@dataclass(frozen=True, slots=True)
class Curves(Generic[RecordT, StateT]):
    columns: int  # number of curves
    # Updates a state from records. Returns rows with a time in s and a value for each curve.
    rows_of: Callable[[StateT, Iterable[RecordT]], list[tuple[float, ...]]]
    max_rows: int  # older rows are dropped
    max_gap: float  # seconds; a longer gap interrupts a curve


@dataclass(frozen=True, slots=True)
class LoadedRecording(Generic[HeaderT, RecordT, StateT]):
    replay: Replay[HeaderT, RecordT, StateT]
    history: SampleHistory  # newest rows
    events: tuple[Event, ...]  # in chronological order
    end: float  # latest time on the session's clock
    rows: int  # number of rows, including dropped rows


def load_recording(
    recording: Recording[HeaderT, RecordT],
    initial: StateT,
    curves: Curves[RecordT, StateT],
    progress: ProgressCallback,
) -> LoadedRecording[HeaderT, RecordT, StateT]:
    """Read a recording. This takes a few seconds per recorded hour.

    Raises:
        RecordingError: the file cannot be read.
    """
    replay = Replay(recording, initial)
    capacity = min(curves.max_rows, max(4096, recording.count))
    history = SampleHistory(curves.columns, capacity=capacity, max_gap=curves.max_gap)
    events, last_time, count = list[Event](), -np.inf, 0
    while replay.progress < 1:
        records, rows = replay.read_next(curves.rows_of)
        if rows:
            times, *columns = np.array(rows).T
            times = np.maximum.accumulate(np.maximum(times, last_time))
            last_time = float(times[-1])
            history.extend(times, columns)
            count += len(rows)
        events += [_event(record) for record in records if isinstance(record, Marker)]
        progress(replay.progress)
    events.sort(key=attrgetter("time"))
    end = max(recording.header.clock, replay.latest)
    return LoadedRecording(replay, history, tuple(events), end, count)


def _event(marker: Marker) -> Event:
    is_known = marker.kind in set(EventKind)
    kind = EventKind(marker.kind) if is_known else EventKind.NOTE
    return Event(marker.time, kind, marker.text[:_MAX_EVENT_LENGTH])


def _export(
    recording: Recording[Any, Any],
    path: Path,
    span: tuple[float, float],
    header: dict[str, Value],
    progress: ProgressCallback,
) -> Path:
    # The GUI thread is using `recording`.
    copy: Recording[Any, Any] = Recording(recording.path, recording.format)
    with closing(copy):
        export_span(copy, path, span, header, progress)
    return path


class RecordingPlayer(QObject, Generic[HeaderT, RecordT, StateT]):
    """Recording with a playback position.

    The position is between `start` and `end`, in seconds on the session's clock. A subclass
    defines the curves of a device. Before the recording is loaded, only its header is available.
    """

    progressed = Signal()  # `progress` or `end` has changed, or the work was cancelled
    moved = Signal()  # `position` has changed
    playing_changed = Signal()
    loaded = Signal()
    exported = Signal(object)  # the `Path` of the exported file
    failed = Signal(str)  # loading or export error, for the user

    def __init__(
        self,
        recording: Recording[HeaderT, RecordT],
        initial: StateT,
        curves: Curves[RecordT, StateT],
    ) -> None:
        """`recording`: open, not loaded. `initial`: state before the recording starts."""
        super().__init__()
        self.start = self.end = self.position = recording.header.clock
        self.speed = 1.0  # 1 is real time
        self.is_loaded = False
        self._timer = new_timer(self, FRAME_MS, self._on_frame)
        self._last_frame = 0.0
        self.path = recording.path
        self.header = recording.header
        self.events: Sequence[Event] = ()
        self._recording = recording
        self._initial = initial
        self._curves = curves
        self._replay: Replay[HeaderT, RecordT, StateT] | None = None
        self._rows = 0
        self._history = SampleHistory(curves.columns, capacity=4096)
        self._traces: Traces | None = None
        self.progress = 0.0  # completed fraction of loading or exporting, 0 to 1
        self._task = FileTask(self)
        self._task.progressed.connect(self._on_progressed)
        self._task.done.connect(self._on_done)

    @property
    def playing(self) -> bool:
        return self._timer.isActive()

    def set_position(self, time: float) -> None:
        time = max(self.start, min(self.end, time))
        if time != self.position:
            self.position = time
            self.moved.emit()

    def play(self) -> None:
        """Play from the position, or from the start if the position is at the end."""
        if self.position >= self.end:
            self.set_position(self.start)
        self._last_frame = now()
        self._timer.start()
        self.playing_changed.emit()

    def pause(self) -> None:
        if self.playing:
            self._timer.stop()
            self.playing_changed.emit()

    def advance(self, seconds: float) -> None:
        self.set_position(self.position + seconds * self.speed)
        if self.position >= self.end and self.is_loaded:
            self.pause()

    @Slot()
    def _on_frame(self) -> None:
        previous, self._last_frame = self._last_frame, now()
        self.advance(self._last_frame - previous)

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        raise NotImplementedError

    def close(self) -> bool:
        """Cancel loading or exporting, and close the file. Return whether the thread has ended."""
        self.pause()
        if not self._task.close(_CLOSE_TIMEOUT_MS):
            return False  # the thread may still use the file
        self._recording.close()
        return True

    @property
    def problems(self) -> Sequence[str]:
        return self._recording.problems if self.is_loaded else ()

    @property
    def is_busy(self) -> bool:
        return self._task.is_running

    @property
    def traces(self) -> Traces:
        if self._traces is None:
            self._traces = self.traces_of(self._history, self.events)
        return self._traces

    @property
    def row_counts(self) -> tuple[int, int]:
        """Number of drawn rows, and number of all rows."""
        return len(self._history), self._rows

    def state(self) -> StateT:
        return self.state_at(self.position)

    def state_at(self, time: float) -> StateT:
        if self._replay is not None:
            try:
                return self._replay.at(time)
            except RecordingError as error:
                self.failed.emit(str(error))
        return self._initial

    def loader(self) -> Callable[[ProgressCallback], LoadedRecording[HeaderT, RecordT, StateT]]:
        return partial(load_recording, self._recording, self._initial, self._curves)

    def start_loading(self) -> None:
        self._start(self.loader())

    def export_header(self, start: float) -> dict[str, Value]:
        """Return the header of an export. Subclasses add the settings at `start`."""
        del start
        return {"device": self._recording.format.device, **self.header.values()}

    def export(self, path: Path, start: float, end: float) -> None:
        """Write a span as CSV or MCAP. `exported` or `failed` is emitted at the end."""
        if self.is_loaded and not self.is_busy:
            span, header = (start, end), self.export_header(start)
            self._start(partial(_export, self._recording, path, span, header))

    def cancel(self) -> None:
        self._task.cancel()

    def _start(self, work: Callable[[ProgressCallback], object]) -> None:
        self.progress = 0.0
        self._task.start(work)

    @Slot(float)
    def _on_progressed(self, progress: float) -> None:
        self.progress = progress
        self.progressed.emit()

    @Slot(object)
    def _on_done(self, done: Done) -> None:
        if isinstance(done.result, LoadedRecording):
            self._set_recording(done.result)
        elif isinstance(done.result, Path):
            self.exported.emit(done.result)
        elif done.error is not None:
            self.failed.emit(str(done.error))
        else:
            self.progressed.emit()

    def _set_recording(self, loaded: LoadedRecording[HeaderT, RecordT, StateT]) -> None:
        self._replay, self.is_loaded, self.progress = loaded.replay, True, 1.0
        self._history, self._rows = loaded.history, loaded.rows
        self.events = loaded.events
        self._traces = None
        self.end = loaded.end
        self.progressed.emit()
        self.loaded.emit()
