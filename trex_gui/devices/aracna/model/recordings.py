"""Recorder of a robot, and player of its recordings."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import Slot

from trex_gui.core.events import Event, EventKind
from trex_gui.core.recording.kinds import marker
from trex_gui.core.recording.store import Recording
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.joints import degrees
from trex_gui.devices.aracna.protocol.replies import UNREADABLE
from trex_gui.devices.aracna.recording import FORMAT, Record, Report, RobotHeader
from trex_gui.devices.aracna.session.messages import Moving, Progress, SpeedsHeld
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.playback.player import Curves, RecordingPlayer
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.record_thread import RecordThread

COLORS = ("motor1", "motor2", "good", "dirty", "danger", "muted", "warning", "plot_text")
"""Theme colours of the curves by motor. Each curve also shows the number of its motor."""

MAX_ROWS = 2_000_000  # drawn rows: six hours of eight motors at their highest rate, 144 MB
_NO_GAP = math.inf  # curves have no gaps: without a report, a position has not changed

_Row = tuple[float, ...]  # time (s), then the position of each motor (degrees; NaN if unknown)


class AracnaRecorder(RecordThread[Record]):
    """Records the session of a robot into one file at a time.

    A recording ends with the connection, or when the number of motors changes, because its columns
    depend on that number. It continues while the robot does not respond.
    """

    def __init__(self, robot: Robot) -> None:
        super().__init__()
        self._robot = robot
        self._motors = 0

        robot.reported.connect(self._on_reported)
        robot.events.happened.connect(self.put_event)
        robot.rejected.connect(self._on_rejected)
        robot.link_changed.connect(self._on_link_changed)

    @property
    def is_available(self) -> bool:
        return self._robot.link is ConnectionState.CONNECTED

    def start(self, path: Path) -> bool:
        if not self.can_record:
            return False
        self._motors = self._robot.state.motors
        header = RobotHeader(datetime.now(UTC), now(), self._robot.state.version or 0, self._motors)
        self.start_recording(path, FORMAT, header, self._initial_records(header.clock))
        return True

    @Slot()
    def stop(self) -> None:
        """End the recording. A marker at the end preserves its full length."""
        self.put(marker(now(), EventKind.NOTE.value, tr("The recording ends here.")))
        super().stop()

    def _initial_records(self, time: float) -> Sequence[Record]:
        state, records = self._robot.state, list[Record]()
        if state.moved is not None:
            records.append(replace(state.moved, time=time))
        elif any(position is not None for position in state.present):
            positions = tuple(UNREADABLE if value is None else value for value in state.present)
            records.append(Progress(time, positions))
        if state.speeds is not None:
            records.append(SpeedsHeld(time, state.speeds.requested, state.speeds.held))
        if state.moving is not None and state.ends_at is not None:
            remaining = max(state.ends_at - time, 0.0)
            records.append(replace(state.moving, time=time, expected=remaining))
        if state.stuck is not None:
            records.append(replace(state.stuck, time=time))
        return records

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        if isinstance(report, Report):
            self.put(report)

    @Slot(str)
    def _on_rejected(self, text: str) -> None:
        self.put(marker(now(), EventKind.NOTE.value, text))

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._robot.link is ConnectionState.DISCONNECTED:
            self.stop_early(tr("Recording {0} ended because the connection was closed."))
        elif self.recording and self._robot.state.motors != self._motors:
            self.stop_early(tr("Recording {0} ended: the number of motors has changed."))
        else:
            self.changed.emit()


class RobotPlayback(RecordingPlayer[RobotHeader, Record, RobotState]):
    def __init__(
        self, recording: Recording[RobotHeader, Record], *, max_rows: int = MAX_ROWS
    ) -> None:
        motors = recording.header.motors
        curves = Curves(motors, _rows, max_rows, _NO_GAP)
        super().__init__(recording, RobotState(motors), curves)

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        return Traces([_trace(motor) for motor in range(self.header.motors)], history, events)


def _trace(motor: int) -> TraceInfo:
    label = tr("Motor {0}").format(motor)
    color = COLORS[motor % len(COLORS)]
    return TraceInfo(f"motor_{motor}", label, "°", color, str(motor))


def _rows(state: RobotState, records: Iterable[Record]) -> list[_Row]:
    """Return a row for each start of a motion, and for each record outside motions.

    During a motion, a curve is straight, because the real path is unknown.
    """
    rows = list[_Row]()
    for record in records:
        state.update(record)
        if state.moving is None or isinstance(record, Moving):
            angles = (math.nan if unit is None else degrees(unit) for unit in state.present)
            rows.append((record.time, *angles))
    return rows
