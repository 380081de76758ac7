"""Going once through a recording: its curves, its events, and what was known, in one go."""

from bisect import insort
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from trex_gui.core.recording.block_replay import BlockReplay, LatestT
from trex_gui.core.recording.blocks import BlockFile, HasStartTime, RecordT
from trex_gui.devices.trex.recording.recording import Marker
from trex_gui.ui.devices.event_log import Event, EventKind
from trex_gui.ui.plotting.data.history import SampleHistory

_LOOKING = 0.2
"""Share of the work that looking through the file is, about."""

ReplayT = TypeVar("ReplayT")


@dataclass(frozen=True, slots=True)
class LoadedRecording(Generic[ReplayT]):
    """What was gathered; whoever is given it owns it, the file in `replay` included.

    Attributes:
        replay: it has gone through every block.
        history: a row for each sample that is drawn.
        events: in the order of time.
        end: the latest time, on the session's clock.
        rows: how many there were; the history holds the last of them.
    """

    replay: ReplayT
    history: SampleHistory
    events: tuple[Event, ...]
    end: float
    rows: int


@dataclass(frozen=True, slots=True)
class LoadedColumns(Generic[RecordT, LatestT]):
    """What is drawn of a recording.

    Attributes:
        columns: how many curves.
        rows_of: returns a row for each sample that is drawn, its time (s) and a value for each
            curve, from what was known before a block (which it may change) and its records.
        most_rows: how many of them are kept: the last.
        max_gap: seconds without a sample after which a curve is interrupted.
    """

    columns: int
    rows_of: Callable[[LatestT, Iterable[RecordT]], list[tuple[float, ...]]]
    most_rows: int
    max_gap: float


def load_recording(
    file: BlockFile[HasStartTime, RecordT],
    replay: BlockReplay[RecordT, LatestT],
    drawn: LoadedColumns[RecordT, LatestT],
    tell: Callable[[float], None],
) -> LoadedRecording[BlockReplay[RecordT, LatestT]]:
    """Read a recording of which only the head was read; it takes seconds an hour.

    `replay` has gone through nothing of it yet. `tell` is told the share that is done, 0 to 1;
    what it raises ends the work.

    Raises:
        RecordingError: it cannot be read.
    """
    file.look_through(lambda share: tell(_LOOKING * share))
    count = sum(block.count for block in file.blocks)
    capacity = min(drawn.most_rows, max(4096, count))
    history = SampleHistory(drawn.columns, capacity=capacity, max_gap=drawn.max_gap)
    events, latest_row, rows = list[Event](), -np.inf, 0
    for done, _ in enumerate(file.blocks, 1):
        latest, records = replay.go_through_next()
        found = drawn.rows_of(latest, records)
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
    return LoadedRecording(replay, history, tuple(events), end, rows)


def _kind_of(marker: Marker) -> EventKind:
    try:
        return EventKind(marker.kind)
    except ValueError:
        return EventKind.NOTE
