"""Recording what a robot reports and the commands sent to it."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QObject, Slot

from trex_gui.core.recording.kinds import marker
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.recording import FORMAT, Header, Record, Report, StoppedResponding
from trex_gui.devices.aracna.session.messages import NotResponding, Passed, SpeedsHeld
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import EventKind
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.record_thread import RecordThread


class AracnaRecorder(RecordThread[Record]):
    """Records the session of a robot into one file at a time.

    A recording ends with the connection, and when the robot returns with another number of motors,
    since its columns would be wrong. It continues while the robot does not respond.
    """

    def __init__(self, robot: Robot, parent: QObject | None = None) -> None:
        super().__init__(parent)
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
        header = Header(datetime.now(UTC), now(), self._robot.state.version or 0, self._motors)
        self.begin(path, FORMAT, header, self._known_at(header.clock))
        return True

    @Slot()
    def stop(self) -> None:
        """End the recording; `ended` follows once the file is complete.

        A last marker keeps its length, since nothing may have happened for a long time.
        """
        self.put(marker(now(), EventKind.NOTE.value, self.tr("The recording ends here.")))
        super().stop()

    def _known_at(self, time: float) -> Sequence[Record]:
        known, records = self._robot.state, list[Record]()
        if known.moved is not None:
            records.append(replace(known.moved, time=time))
        elif any(place is not None for place in known.present):
            places = tuple(-1 if place is None else place for place in known.present)
            records.append(Passed(time, places))
        if known.speeds is not None:
            records.append(SpeedsHeld(time, known.speeds.requested, known.speeds.held))
        if known.moving is not None and known.ends_at is not None:
            left = max(known.ends_at - time, 0.0)
            records.append(replace(known.moving, time=time, expected=left))
        if known.stuck is not None:
            records.append(replace(known.stuck, time=time))
        return records

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        if isinstance(report, Report):
            self.put(report)
        elif isinstance(report, NotResponding):
            self.put(StoppedResponding(now()))

    @Slot(str)
    def _on_rejected(self, text: str) -> None:
        self.put(marker(now(), EventKind.NOTE.value, text))

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._robot.link is ConnectionState.DISCONNECTED:
            self.end_because(self.tr("Recording {0} ended with the connection."))
        elif self.recording and self._robot.state.motors != self._motors:
            self.end_because(self.tr("Recording {0} ended: the number of motors has changed."))
        else:
            self.changed.emit()
