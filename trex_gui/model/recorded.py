"""All that is drawn of a recording, gathered in one go: its curves, its events, what was known."""

from bisect import insort
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trex_gui.link.telemetry import Currents
from trex_gui.model.events import Event, EventKind
from trex_gui.model.telemetry import Series
from trex_gui.model.trace.history import History
from trex_gui.protocol.flags import CHANNELS
from trex_gui.recording.recording import Marker, Record, RecordingFile
from trex_gui.recording.replay import Latest, Replay

MOST_ROWS = 3_000_000
"""Rows that can be drawn: ten hours at 80 a second, 240 MB."""

_LOOKING = 0.2
"""Share of the work that looking through the file is, about."""

_UNKNOWN = (np.nan,) * len(CHANNELS)


@dataclass(frozen=True, slots=True)
class Recorded:
    """What was gathered; whoever is given it owns it, the file in `replay` included.

    Attributes:
        replay: it has gone through every block.
        history: a row for each sample of the currents; its columns are `telemetry.Series`.
        events: in the order of time.
        end: the latest time, on the session's clock.
        rows: how many there were; the history holds the last of them.
    """

    replay: Replay
    history: History
    events: tuple[Event, ...]
    end: float
    rows: int


def gather(file: RecordingFile, tell: Callable[[float], None], most_rows: int) -> Recorded:
    """Read a recording of which only the head was read; it takes seconds an hour.

    `tell` is told the share that is done, 0 to 1; what it raises ends the work.

    Raises:
        RecordingError: it cannot be read.
    """
    file.look_through(lambda share: tell(_LOOKING * share))
    count = sum(block.count for block in file.blocks)
    history = History(len(Series), capacity=min(most_rows, max(4096, count)))
    replay, events, latest_row, rows = Replay(file), list[Event](), -np.inf, 0
    for done, _ in enumerate(file.blocks, 1):
        latest, records = replay.go_through_next()
        found = _rows(latest, records, file.header.model.current_unit)
        if found:
            times, *columns = np.array(found).T
            times = np.maximum.accumulate(np.maximum(times, latest_row))
            latest_row = float(times[-1])
            history.extend(times, columns)
            rows += len(found)
        for record in records:
            if isinstance(record, Marker):
                event = Event(record.time, _kind_of(record), record.text)
                insort(events, event, key=lambda one: one.time)
        tell(min(1.0, _LOOKING + (1 - _LOOKING) * done / len(file.blocks)))
    end = max([file.header.clock, *(block.last for block in file.blocks)])
    return Recorded(replay, history, tuple(events), end, rows)


def _rows(latest: Latest, records: list[Record], unit: float) -> list[tuple[float, ...]]:
    """Return a row for each sample of the currents, with what was known beside it."""
    rows = []
    for record in records:
        latest.take(record)
        if isinstance(record, Currents):
            drives = [latest.wishes.get(motor) for motor in (1, 2)]
            rows.append(
                (
                    record.time,
                    *(count * unit for count in record.counts),
                    *(drive.signed if drive else 0.0 for drive in drives),
                    *(latest.remapped or _UNKNOWN),
                )
            )
    return rows


def _kind_of(marker: Marker) -> EventKind:
    try:
        return EventKind(marker.kind)
    except ValueError:
        return EventKind.NOTE
