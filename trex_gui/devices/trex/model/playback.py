"""Playback of a recording of a board."""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial

from trex_gui.core.events import Event
from trex_gui.core.files import SettingsError
from trex_gui.core.recording.kinds import Value
from trex_gui.core.recording.store import Recording
from trex_gui.devices.trex.client.telemetry import Currents
from trex_gui.devices.trex.model.telemetry import Series, board_traces, values_of_series
from trex_gui.devices.trex.protocol.parameters import MotorParameter
from trex_gui.devices.trex.recording import BoardSnapshot, Header, Record
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.ui.playback.player import Curves, RecordingPlayer
from trex_gui.ui.plotting.history import MAX_GAP, SampleHistory
from trex_gui.ui.plotting.traces import Traces

MAX_ROWS = 3_000_000  # ten hours at 80 rows per second, 240 MB


class Playback(RecordingPlayer[Header, Record, BoardSnapshot]):
    def __init__(self, recording: Recording[Header, Record]) -> None:
        header = recording.header
        rows_of = partial(_rows, unit=header.model.current_unit)
        curves = Curves(len(Series), rows_of, MAX_ROWS, MAX_GAP)
        super().__init__(recording, BoardSnapshot.at_start(header), curves)
        self._limits = limits_in(header.settings)

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        return Traces(board_traces(), history, events, self._limits)

    def export_header(self, start: float) -> dict[str, Value]:
        return {**super().export_header(start), "settings": self.state_at(start).settings}


def _rows(state: BoardSnapshot, records: Iterable[Record], unit: float) -> list[tuple[float, ...]]:
    rows = []
    for record in records:
        state.update(record)
        if isinstance(record, Currents):
            values = values_of_series(state, state.setpoints.get, unit)
            rows.append((record.time, *values))
    return rows


def limits_in(text: str) -> Mapping[str, float]:
    """Return the current limits (A) in a settings text, by curve name."""
    try:
        settings, _ = read_settings(text.encode("utf-8"), "settings")
    except (SettingsError, UnicodeError):
        return {}
    limits = {}
    for motor in (1, 2):
        key = MotorParameter.CURRENT_LIMIT.of(motor)
        if wire := settings.parameters.get(key):
            limits[f"motor{motor}_current"] = wire * settings.specs[key].scale
    return limits
