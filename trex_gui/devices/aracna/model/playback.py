"""A recording of a robot that is looked at: its curves, its events, what was known."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from trex_gui.core.recording.block_replay import BlockReplay
from trex_gui.devices.aracna.model.recorded import MOST_ROWS, Moment, gather
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.recording import Header, Row
from trex_gui.devices.aracna.recording.csv_reader import RobotCsvFile, open_recording
from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.playback.player import RecordingPlayer
from trex_gui.ui.playback.recording_loader import LoadedRecording
from trex_gui.ui.plotting.data.history import SampleHistory
from trex_gui.ui.plotting.data.traces import TraceInfo, Traces
from trex_gui.ui.workers.file_worker import ProgressCallback

COLORS = ("motor1", "motor2", "good", "dirty", "danger", "muted", "warning", "plot_text")
"""The theme's colours of the motors' curves, motor 0 first; a number stands at each, too."""


class RobotPlayback(RecordingPlayer[Header, Row, Moment]):
    """One recording of a robot; a curve for each motor, in degrees."""

    def __init__(
        self,
        file: RobotCsvFile,
        path: Path,
        parent: QObject | None = None,
        *,
        most_rows: int = MOST_ROWS,
    ) -> None:
        """Take a recording of which only the head was read, and `start_reading` the rest.

        Of its answers the last `most_rows` are drawn.
        """
        super().__init__(file, path, parent, columns=file.header.motors)
        self._file = file
        self._most_rows = most_rows

    @classmethod
    def open(cls, path: Path, parent: QObject | None = None) -> "RobotPlayback":
        """Open a recording and begin to read it.

        Raises:
            RecordingError: there is none that can be read.
        """
        playback = cls(open_recording(path), path, parent)
        playback.start_reading()
        return playback

    def loader(self) -> Callable[[ProgressCallback], LoadedRecording[BlockReplay[Row, Moment]]]:
        return partial(gather, self._file, most_rows=self._most_rows)

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        return Traces([_trace(motor) for motor in range(self.header.motors)], history, events)

    def first(self) -> Moment:
        return Moment(RobotState(self.header.motors))


def _trace(motor: int) -> TraceInfo:
    label = QCoreApplication.translate("RobotPlayback", "Motor {0}").format(motor)
    color = COLORS[motor % len(COLORS)]
    return TraceInfo(f"motor_{motor}", label, "°", color, str(motor))
