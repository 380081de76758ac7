"""Recording what a robot reports and what is asked of it, while it happens."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Slot

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.recording import CsvWriter, FellSilent, Header, Row
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    NotResponding,
    Passed,
    PlayEnded,
    Restarted,
    SpeedsHeld,
    StepBegun,
    Stuck,
)
from trex_gui.devices.trex.recording.records_from import marker
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.event_log import Event, EventKind
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.record_thread import RecordThread


class AracnaRecorder(RecordThread[Row]):
    """Writes the session of a robot into one CSV file at a time.

    A recording ends with the connection, and where the robot comes back with another number of
    motors: its columns would be wrong. While the robot is only silent it goes on.
    """

    def __init__(
        self,
        robot: Robot,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = now,
    ) -> None:
        """Record nothing yet; `clock` is the session's."""
        super().__init__(parent, clock=clock)
        self._robot = robot
        self._motors = 0

        robot.reported.connect(self._on_reported)
        robot.events.happened.connect(self._on_happened)
        robot.rejected.connect(self._on_rejected)
        robot.link_changed.connect(self._on_link_changed)

    @property
    def is_there(self) -> bool:
        """Whether a robot answers."""
        return self._robot.link is ConnectionState.CONNECTED

    def start(self, path: Path) -> bool:
        """Record into a CSV file from now on; return whether that is possible now.

        A file of that name is replaced.
        """
        if not self.can_record:
            return False
        now = self.clock()
        self._motors = self._robot.motors
        header = Header(datetime.now(UTC), now, self._robot.version or 0, self._motors)
        self.begin(path, now, partial(CsvWriter, header=header), self._known_at(now))
        return True

    @Slot()
    def stop(self) -> None:
        """End the recording; `ended` follows when its last byte is written.

        Its last row says so: nothing else may have happened for long, and it is as long as it was.
        """
        self.put(marker(self.clock(), EventKind.NOTE.value, self.tr("The recording ends here.")))
        super().stop()

    # --- What is recorded ---------------------------------------------------------------

    def _known_at(self, now: float) -> Sequence[Row]:
        """Return where the motors are, what they do and which speeds they hold, where known."""
        known, rows = self._robot.known, list[Row]()
        if known.moved is not None:
            rows.append(replace(known.moved, time=now))
        elif any(place is not None for place in known.present):
            places = tuple(-1 if place is None else place for place in known.present)
            rows.append(Passed(now, places))
        if known.speeds is not None:
            rows.append(SpeedsHeld(now, known.speeds.requested, known.speeds.held))
        if known.moving is not None and known.ends_at is not None:
            left = max(known.ends_at - now, 0.0)
            rows.append(replace(known.moving, time=now, expected=left))
        if known.stuck is not None:
            rows.append(replace(known.stuck, time=now))
        return rows

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        match report:
            case (
                Moving()
                | Passed()
                | Moved()
                | SpeedsHeld()
                | StepBegun()
                | PlayEnded()
                | Stuck()
                | Restarted()
            ):
                self.put(report)
            case NotResponding():
                self.put(FellSilent(self.clock()))
            case _:
                pass

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        self.put(marker(event.time, event.kind.value, event.text))

    @Slot(str)
    def _on_rejected(self, text: str) -> None:
        self.put(marker(self.clock(), EventKind.NOTE.value, text))

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._robot.link is ConnectionState.DISCONNECTED:
            self.end_because(self.tr("The recording {0} has ended with the connection."))
        elif self.recording and self._robot.motors != self._motors:
            self.end_because(self.tr("The recording {0} has ended: the robot has other motors."))
        else:
            self.changed.emit()
