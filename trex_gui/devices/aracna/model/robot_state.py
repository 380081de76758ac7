"""State of the robot, as reported by its session or a recording."""

from dataclasses import dataclass, field

from trex_gui.devices.aracna.protocol.replies import UNREADABLE
from trex_gui.devices.aracna.session.errors import RobotError, missed_goals, rejected_speeds
from trex_gui.devices.aracna.session.messages import (
    Connected,
    LineStats,
    Moved,
    Moving,
    NotResponding,
    Play,
    PlayEnded,
    Progress,
    Restarted,
    SpeedsHeld,
    StepStarted,
    Stuck,
)


@dataclass(slots=True)
class RobotState:
    """Last reported values. Times are on the session clock."""

    motors: int
    version: int | None = None
    present: tuple[int | None, ...] = ()  # positions; `None`: unknown
    goals: tuple[int, ...] | None = None  # last sent goals
    moving: Moving | None = None  # unanswered `.c`
    moved: Moved | None = None
    awaited_motor: int = 0
    stuck: Stuck | None = None
    uncertain: bool = False  # True while an unobserved motion may be running
    unobserved_until: float | None = None  # time at which this motion should end
    speeds: SpeedsHeld | None = None
    led: bool | None = None  # debug LED; `None` before it was switched
    play: Play | None = None
    step: StepStarted | None = None  # running step
    stats: LineStats = field(default_factory=LineStats)

    def __post_init__(self) -> None:
        self.present = (None,) * self.motors

    def update(self, report: object) -> None:
        match report:
            case Moving(goals=goals):
                self.moving, self.goals = report, goals
                self.awaited_motor, self.stuck, self.moved = 0, None, None
                self.uncertain, self.unobserved_until = False, None  # every motor has a new goal
            case Progress(present=present):
                self._set_present(present)
                self.awaited_motor = min(len(present), self.motors - 1)
                if self.stuck is not None and self.stuck.motor != self.awaited_motor:
                    self.stuck = None  # the motor has arrived
            case Moved():
                self._handle_moved(report)
            case Stuck():
                self.stuck = report
            case SpeedsHeld():
                self.speeds = report
            case Restarted() | NotResponding():
                self.present = (None,) * self.motors
                self._stop_observing()
                self.moved, self.speeds, self.led = None, None, None
                self.uncertain, self.step = self.goals is not None, None
            case Connected(version=version):
                self.version = version
                # A robot that replies to `.q` is not waiting for a motor. Servos may still be
                # moving, because the reset on opening the port does not stop them.
                self._stop_observing()
            case StepStarted():
                self.step = report
            case PlayEnded():
                self.play = self.step = None
            case LineStats():
                self.stats = report

    def _stop_observing(self) -> None:
        if self.moving is not None:
            self.unobserved_until, self.uncertain = self.ends_at, True
        self.moving, self.stuck = None, None

    def _handle_moved(self, moved: Moved) -> None:
        self._set_present(moved.present)
        self.moved, self.goals = moved, moved.goals
        if self.reply_lost:
            self._stop_observing()
        else:
            self.moving, self.stuck = None, None
            self.uncertain, self.unobserved_until = False, None

    def _set_present(self, present: tuple[int, ...]) -> None:
        positions = present[: self.motors]
        known = tuple(None if value == UNREADABLE else value for value in positions)
        self.present = known + self.present[len(known) :]

    @property
    def reply_lost(self) -> bool:
        """True if the last reply to a `.c` was lost, or no servo replied."""
        return self.moved is not None and set(self.moved.present) == {UNREADABLE}

    @property
    def missed_goals(self) -> dict[int, RobotError]:
        return {} if self.moved is None else missed_goals(self.moved.goals, self.moved.present)

    @property
    def speed_error(self) -> RobotError | None:
        speeds = self.speeds
        return None if speeds is None else rejected_speeds(speeds.requested, speeds.held)

    def held_speed(self, motor: int) -> int | None:
        """Return a servo's last reported speed. `None` if unknown."""
        if self.speeds is None or motor >= len(self.speeds.held):
            return None
        return self.speeds.held[motor]

    @property
    def ends_at(self) -> float | None:
        return None if self.moving is None else self.moving.time + self.moving.expected

    @property
    def moving_until(self) -> float | None:
        """Expected end of any motion, on the session clock."""
        return self.unobserved_until if self.moving is None else self.ends_at

    @property
    def may_be_moving(self) -> bool:
        """True if a motion may be running unobserved.

        This includes the time before the first reply to a `.c`, because another host may have moved
        the robot.
        """
        return self.moving is None and (self.moved is None or self.reply_lost)
