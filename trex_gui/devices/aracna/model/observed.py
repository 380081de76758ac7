"""The robot as far as it is looked at: its line, and what it reports."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError, sentence
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.connection import RobotConnection
from trex_gui.devices.aracna.model.event_log import RobotEventLog
from trex_gui.devices.aracna.model.limits import JointLimits
from trex_gui.devices.aracna.model.robot_state import PlayState, Rate, RobotState
from trex_gui.devices.aracna.model.speeds import ServoSpeeds
from trex_gui.devices.aracna.model.targets import Targets
from trex_gui.devices.aracna.protocol.units import MOTORS
from trex_gui.devices.aracna.session.errors import suggests_scan
from trex_gui.devices.aracna.session.messages import (
    Connected,
    DragDropped,
    LineStats,
    LineStatsChanged,
    Moved,
    Moving,
    SetLimits,
)
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import EventKind, EventLog
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import now
from trex_gui.ui.traffic.model import TrafficModel


class ObservedRobot(QObject):
    """One robot, or none: its line, and everything that it has reported.

    Positions and speeds are tuples of one value a motor, motor 0 first, in the servo's units.

    Signals:
        link_changed: `link`, `status`, `motors` or `version`.
        changed: anything else that is known: positions, speeds, what is moving or played.
        reported: a report of the session, after it was taken in; for what records.
        halted: a person has stopped everything; what is held down is to be let go.
        rejected: why a command was not carried out; the notifier reports it, too.
    """

    link_changed = Signal()
    changed = Signal()
    reported = Signal(object)
    halted = Signal()
    rejected = Signal(str)

    def __init__(
        self,
        notifier: Notifier | None = None,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = now,
    ) -> None:
        """Know of no robot yet; `clock` is the session's."""
        super().__init__(parent)
        self.notifier = notifier or Notifier(self)
        self._clock = clock
        self._version: int | None = None
        self._counters = LineStats()
        self._known = RobotState(MOTORS)
        self._rate = Rate()
        self._moves_waiting = 0
        self._dragging = False
        self._holding = False
        self._line = RobotConnection(self)
        self.limits = JointLimits(self)
        self.targets = Targets(self.limits, self)
        self.speeds = ServoSpeeds(self._line, self)
        self.events = EventLog(self, clock=clock)
        self._story = RobotEventLog(self.events)

        self.limits.changed.connect(self._send_limits)
        self.speeds.changed.connect(self.changed)
        self.rejected.connect(self.notifier.error)
        self.speeds.refused.connect(self.rejected)
        self._line.reported.connect(self._on_reported)
        self._line.device_read.connect(self._on_answered)
        self._line.state_lost.connect(self._on_lapsed)
        self._line.line_closed.connect(self._on_left)
        self._line.changed.connect(self._on_link_changed)
        self._line.failed.connect(self._on_failed)

    # --- What is known ------------------------------------------------------------------

    @property
    def link(self) -> ConnectionState:
        """How things stand."""
        return self._line.link

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        return self._line.status

    @property
    def traffic(self) -> TrafficModel:
        """Every byte that went over its line."""
        return self._line.traffic

    @property
    def version(self) -> int | None:
        """The version of its firmware; `None` before it has answered."""
        return self._version

    @property
    def counters(self) -> LineStats:
        """What the line has seen since the robot has answered first, as it was told last."""
        return self._counters

    @property
    def motors(self) -> int:
        """How many motors it has; eight before it has answered."""
        return self._known.motors

    @property
    def known(self) -> RobotState:
        """Everything that it has reported; not to be written to."""
        return self._known

    @property
    def present(self) -> tuple[int | None, ...]:
        """Where each motor was last reported; `None` where that is not known."""
        return tuple(self._known.present)

    @property
    def playing(self) -> PlayState | None:
        """What is being played."""
        return self._known.playing

    @property
    def dragging(self) -> bool:
        """Whether goals are sent as somebody drags."""
        return self._dragging

    @property
    def rate(self) -> float | None:
        """Commands a second that were answered lately, while somebody dragged."""
        return self._rate.per_second

    def remaining(self) -> float:
        """Return the seconds until the running motion should end; 0 where none runs.

        One that was left running, when the line was closed or the board restarted, goes on and
        counts.
        """
        until = self._known.goes_on_until
        return 0.0 if until is None else max(until - self._clock(), 0.0)

    @Slot()
    def _send_limits(self) -> None:
        """Let the session enforce the newest limits, on what is played as well."""
        pairs = tuple((each.low, each.high) for each in self.limits.first(self.motors))
        self._line.submit(SetLimits(pairs))

    # --- The line -----------------------------------------------------------------------

    def connect_to(self, settings: PortSettings) -> None:
        """Open a line; one that is open is closed first."""
        self._line.open(settings)

    def disconnect_line(self) -> None:
        """Send nothing more and close the line; does not wait for it."""
        self._line.close()

    def shut_down(self) -> bool:
        """Close the line for the end of the program; return whether it ended in time."""
        return self._line.shut_down()

    def _hold(self) -> None:
        """Want the motors where they are, so that the next move begins there."""
        goals = self.targets.goals
        self.targets.set_all(
            [
                goals[motor] if position is None else position
                for motor, position in enumerate(self._known.present)
            ]
        )

    # --- Reports from the line ----------------------------------------------------------

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        self._known.take(report)
        match report:
            case LineStatsChanged(stats=counters):
                self._counters = counters
            case Moving(goals=goals) if self._known.play is not None:
                self.targets.set_all(goals)
            case Moved(time=moment):
                if self._dragging:
                    self._rate.note(moment)
                if self._holding:
                    self._hold()
            case DragDropped(error=error):
                self._dragging = False  # told once, not with every goal that is dragged over
                self._reject(self.tr("Not moved: {0}").format(sentence(error)))
            case _:
                pass
        self._story.follow(report, self._known)
        self.reported.emit(report)
        self.changed.emit()

    @Slot(object)
    def _on_answered(self, report: Connected) -> None:
        self._version = report.version
        if report.motors != self.motors:
            self._begin_with(report.motors)
        self._send_limits()

    @Slot()
    def _on_lapsed(self) -> None:
        """Nobody drags what does not listen."""
        self._dragging = False

    @Slot()
    def _on_left(self) -> None:
        self._version = None
        self._counters = LineStats()
        self._moves_waiting = 0
        self._begin_with(self.motors)

    def _begin_with(self, motors: int) -> None:
        self._known = RobotState(motors, left_until=self._known.goes_on_until)
        self._rate.forget()
        self._dragging = self._holding = False
        self.speeds.begin(motors)
        self.targets.set_count(motors)
        self.changed.emit()

    def _reject(self, reason: str) -> None:
        self.rejected.emit(reason)

    @Slot()
    def _on_link_changed(self) -> None:
        self.events.add(EventKind.LINK, self.status)
        self.link_changed.emit()

    @Slot(object)
    def _on_failed(self, error: StudioError) -> None:
        reason = str(error)
        self.events.add(EventKind.LINK, reason)
        if suggests_scan(error):
            reason = self.tr("{0} Find a board (Ctrl+Shift+F) tries every setting.").format(reason)
        self.notifier.error.emit(reason)
