"""All that is drawn of a recording of a board: its curves, its events, what was known."""

from collections.abc import Callable, Iterable

import numpy as np

from trex_gui.core.recording.block_replay import BlockReplay
from trex_gui.devices.trex.client.telemetry import Currents
from trex_gui.devices.trex.model.telemetry import Series
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.recording.recording import Record, RecordingFile
from trex_gui.devices.trex.recording.replay import Latest, Replay
from trex_gui.ui.playback.recording_loader import LoadedColumns, LoadedRecording, load_recording
from trex_gui.ui.plotting.data.history import MAX_GAP

MOST_ROWS = 3_000_000
"""Rows that can be drawn: ten hours at 80 a second, 240 MB."""

_UNKNOWN = (np.nan,) * len(CHANNELS)


def gather(
    file: RecordingFile, tell: Callable[[float], None], most_rows: int
) -> LoadedRecording[BlockReplay[Record, Latest]]:
    """Read a recording of which only the head was read; it takes seconds an hour.

    The history has a row for each sample of the currents; its columns are `telemetry.Series`.

    Raises:
        RecordingError: it cannot be read.
    """
    unit = file.header.model.current_unit

    def rows_of(latest: Latest, records: Iterable[Record]) -> list[tuple[float, ...]]:
        return _rows(latest, records, unit)

    return load_recording(
        file, Replay(file), LoadedColumns(len(Series), rows_of, most_rows, MAX_GAP), tell
    )


def _rows(latest: Latest, records: Iterable[Record], unit: float) -> list[tuple[float, ...]]:
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
