"""A recording that is looked at: its curves, its events, and what was known at one time."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal, Slot

from trex_gui.link.telemetry import Currents
from trex_gui.model.events import Event, EventKind
from trex_gui.model.telemetry import Series
from trex_gui.model.trace.board import board_traces
from trex_gui.model.trace.history import History
from trex_gui.model.trace.traces import Traces
from trex_gui.protocol.flags import CHANNELS
from trex_gui.recording.errors import RecordingError
from trex_gui.recording.files import open_recording
from trex_gui.recording.recording import Header, Marker, RecordingFile
from trex_gui.recording.replay import Latest, Replay, export_span
from trex_gui.settings.errors import SettingsError
from trex_gui.settings.reader import read_settings

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""How many times as fast as it happened a recording can be played."""

MOST_ROWS = 3_000_000
"""Rows that can be drawn: ten hours at 80 a second, 240 MB."""

_SLICE_MS = 12
"""Milliseconds of reading after which the window gets its turn."""

_FRAME_MS = 33


class Playback(QObject):
    """One recording, read piece by piece, and a place in it that can be moved and played.

    Signals:
        progressed: more of it was read; `progress`, `traces`, `events` and `end`.
        loaded: all of it was read.
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

    def __init__(self, file: RecordingFile, path: Path, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.path = path
        self._file = file
        self._replay = Replay(file)
        self._events: list[Event] = []
        count = sum(block.count for block in file.blocks)
        self._history = History(len(Series), capacity=min(MOST_ROWS, max(4096, count)))
        self._latest_row = -np.inf
        self._limits = limits_in(file.header.settings)
        self.traces = Traces(board_traces(), self._history, self._events, self._limits)
        self._end = file.header.clock
        self._position = file.header.clock
        self._speed = 1.0
        self._export: tuple[Path, Iterator[float]] | None = None
        self._export_share = 0.0
        self._reading = QTimer(self)
        self._reading.setInterval(0)
        self._playing = QTimer(self)
        self._playing.setInterval(_FRAME_MS)
        self._since = QElapsedTimer()

        self._reading.timeout.connect(self._on_reading)
        self._playing.timeout.connect(self._on_frame)

    @classmethod
    def open(cls, path: Path, parent: QObject | None = None) -> "Playback":
        """Open a recording and begin to read it.

        Raises:
            RecordingError: there is none that can be read.
        """
        playback = cls(open_recording(path), path, parent)
        playback.start_reading()
        return playback

    def close(self) -> None:
        """Give the file back; nothing more can be asked."""
        self._reading.stop()
        self._playing.stop()
        self._export = None
        self._file.close()

    # --- What is known ------------------------------------------------------------------

    @property
    def header(self) -> Header:
        """Of what the recording is."""
        return self._file.header

    @property
    def problems(self) -> Sequence[str]:
        """What is missing of it, as sentences."""
        return self._file.problems

    @property
    def progress(self) -> float:
        """How much of it was read, 0 to 1."""
        blocks = len(self._file.blocks)
        return self._replay.blocks_seen / blocks if blocks else 1.0

    @property
    def is_loaded(self) -> bool:
        """Whether all of it was read."""
        return self._replay.blocks_seen == len(self._file.blocks)

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
        """When it ends on the session's clock, as far as it was read."""
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
    def exporting(self) -> float | None:
        """How much of an export is done, 0 to 1; `None` while there is none."""
        return self._export_share if self._export is not None else None

    def latest(self) -> Latest:
        """Return what was known at the position."""
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
        """Write a span as CSV, bit by bit; ends in `exported` or `failed`."""
        self._export = (path, export_span(self._file, path, start, end))
        self._export_share = 0.0
        self._reading.start()

    def start_reading(self) -> None:
        """Read it bit by bit while the window lives on."""
        self._reading.start()

    def read_all(self) -> None:
        """Read all of it now; for recordings that are known to be short."""
        while not self.is_loaded:
            self._read_block()
        self._reading.stop()
        self.progressed.emit()
        self.loaded.emit()

    # --- Reading ------------------------------------------------------------------------

    @Slot()
    def _on_reading(self) -> None:
        slice_ = QElapsedTimer()
        slice_.start()
        was_loaded = self.is_loaded
        try:
            while not self.is_loaded and slice_.elapsed() < _SLICE_MS:
                self._read_block()
            while self._export is not None and slice_.elapsed() < _SLICE_MS:
                self._export_block(*self._export)
        except RecordingError as error:
            self._reading.stop()
            self._export = None
            self.failed.emit(str(error))
            return
        if self.is_loaded and self._export is None:
            self._reading.stop()
        self.progressed.emit()
        if self.is_loaded and (not was_loaded or not self._file.blocks):
            self.loaded.emit()

    def _read_block(self) -> None:
        block = self._file.blocks[self._replay.blocks_seen]
        latest, records = self._replay.go_through_next()
        rows: list[tuple[float, ...]] = []
        unit = self.header.model.current_unit
        for record in records:
            latest.take(record)
            match record:
                case Currents(time=time, counts=(first, second)):
                    drives = [latest.wishes.get(motor) for motor in (1, 2)]
                    rows.append(
                        (
                            time,
                            first * unit,
                            second * unit,
                            *(drive.signed if drive else 0.0 for drive in drives),
                            *(latest.remapped or _UNKNOWN),
                        )
                    )
                case Marker():
                    self._note(record)
        self._draw(rows)
        self._end = max(self._end, block.last)

    def _draw(self, rows: Sequence[Sequence[float]]) -> None:
        if not rows:
            return
        times, *columns = np.array(rows).T
        times = np.maximum.accumulate(np.maximum(times, self._latest_row))
        self._latest_row = float(times[-1])
        self._history.extend(times, columns)

    def _note(self, marker: Marker) -> None:
        event = Event(marker.time, _kind_of(marker), marker.text)
        place = len(self._events)
        while place and self._events[place - 1].time > event.time:
            place -= 1
        self._events.insert(place, event)

    def _export_block(self, path: Path, work: Iterator[float]) -> None:
        share = next(work, None)
        if share is None:
            self._export = None
            self.exported.emit(path)
        else:
            self._export_share = share

    @Slot()
    def _on_frame(self) -> None:
        self.advance(self._since.restart() / 1000)


_UNKNOWN = (np.nan,) * len(CHANNELS)


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


def _kind_of(marker: Marker) -> EventKind:
    try:
        return EventKind(marker.kind)
    except ValueError:
        return EventKind.NOTE
