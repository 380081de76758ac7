"""A recording of a board that is looked at: its curves, its events, what was known, exports."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from trex_gui.core.files.errors import SettingsError
from trex_gui.core.recording.block_replay import BlockReplay
from trex_gui.devices.trex.model.recordings.recorded import MOST_ROWS, gather
from trex_gui.devices.trex.model.telemetry import Series
from trex_gui.devices.trex.model.traces import board_traces
from trex_gui.devices.trex.protocol.parameter_keys import MotorParameter
from trex_gui.devices.trex.recording.files import open_recording
from trex_gui.devices.trex.recording.recording import Header, Record, RecordingFile
from trex_gui.devices.trex.recording.replay import Latest, export_span
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.playback.player import RecordingPlayer
from trex_gui.ui.playback.recording_loader import LoadedRecording
from trex_gui.ui.plotting.data.history import SampleHistory
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.workers.file_worker import ProgressCallback


class Playback(RecordingPlayer[Header, Record, Latest]):
    """One recording of a board, and what can be written of it.

    Signals:
        exported: a span was written; its `Path`.
    """

    exported = Signal(object)

    def __init__(
        self,
        file: RecordingFile,
        path: Path,
        parent: QObject | None = None,
        *,
        most_rows: int = MOST_ROWS,
    ) -> None:
        """Take a recording of which only the head was read, and `start_reading` the rest.

        Of its samples of the currents the last `most_rows` are drawn.
        """
        super().__init__(file, path, parent, columns=len(Series))
        self._file = file
        self._most_rows = most_rows
        self._limits = limits_in(file.header.settings)
        self._export_path: Path | None = None
        self._export_share = 0.0

    @classmethod
    def open(cls, path: Path, parent: QObject | None = None) -> "Playback":
        """Open a recording and begin to read it.

        Raises:
            RecordingError: there is none that can be read.
        """
        playback = cls(open_recording(path, head_only=True), path, parent)
        playback.start_reading()
        return playback

    def loader(self) -> Callable[[ProgressCallback], LoadedRecording[BlockReplay[Record, Latest]]]:
        return partial(gather, self._file, most_rows=self._most_rows)

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        return Traces(board_traces(), history, events, self._limits)

    def first(self) -> Latest:
        return Latest(self.header.mode, self.header.settings)

    def close(self) -> bool:
        self._export_path = None
        return super().close()

    # --- Exports ------------------------------------------------------------------------

    @property
    def exporting(self) -> float | None:
        """How much of an export is done, 0 to 1; `None` while there is none."""
        return self._export_share if self._export_path is not None else None

    @property
    def working(self) -> float | None:
        return self.exporting if self.is_loaded and self.busy else super().working

    def export(self, path: Path, start: float, end: float) -> None:
        """Write a span as CSV; ends in `exported` or `failed`, unless it is cancelled."""
        if self.busy or not self.is_loaded:
            return
        self._export_path, self._export_share = path, 0.0
        file = self._file

        def work(tell: ProgressCallback) -> Path:
            own = file.again()  # this one goes on showing values
            try:
                export_span(own, path, start, end, tell)
            finally:
                own.close()
            return path

        self.begin(work)

    def cancel_export(self) -> None:
        """Write no further; whatever had the name of the file before is still there."""
        if self._export_path is not None:
            self.cancel_work()

    def note_share(self, share: float) -> None:
        if self._export_path is not None:
            self._export_share = share
        else:
            super().note_share(share)

    def end_with(self, result: object) -> None:
        self._export_path = None
        if isinstance(result, Path):
            self.exported.emit(result)
        else:
            super().end_with(result)


def limits_in(text: str) -> Mapping[str, float]:
    """Return the current limits (A) that settings hold, by the name of the curve."""
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
