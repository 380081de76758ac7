"""State of the robot, as its session or a recording reports it. Uses neither Qt nor a clock."""

from dataclasses import dataclass, field

from trex_gui.devices.aracna.protocol.replies import UNREADABLE
from trex_gui.devices.aracna.session.errors import RobotError, missed_goals, rejected_speeds
from trex_gui.devices.aracna.session.messages import (
    Connected,
    LineStats,
    Moved,
    Moving,
    NotResponding,
    Passed,
    Play,
    PlayEnded,
    Restarted,
    SpeedsHeld,
    StepBegun,
    Stuck,
)


@dataclass(slots=True)
class RobotState:
    """Newest reported values. Times are on the session's clock."""

    motors: int
    version: int | None = None
    present: tuple[int | None, ...] = ()  # position of each motor; `None` where unknown
    goals: tuple[int, ...] | None = None  # last sent
    moving: Moving | None = None  # the `.c` that has no reply yet
    moved: Moved | None = None
    awaited_motor: int = 0
    stuck: Stuck | None = None
    uncertain: bool = False  # whether a motion that is no longer observed may still be running
    unobserved_until: float | None = None  # when that motion should end; retained after its end
    speeds: SpeedsHeld | None = None
    led: bool | None = None  # debug LED; `None` until it was first switched
    play: Play | None = None
    step: StepBegun | None = None  # the running step; `None` before the first
    stats: LineStats = field(default_factory=LineStats)

    def __post_init__(self) -> None:
        self.present = (None,) * self.motors

    def update(self, report: object) -> None:
        match report:
            case Moving(goals=goals):
                self.moving, self.goals = report, goals
                self.awaited_motor, self.stuck, self.moved = 0, None, None
                self.uncertain, self.unobserved_until = False, None  # every motor has a new goal
            case Passed(present=present):
                self._set_present(present)
                self.awaited_motor = min(len(present), self.motors - 1)
                if self.stuck is not None and self.stuck.motor != self.awaited_motor:
                    self.stuck = None  # it has arrived after all
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
                # A robot that answers `.q` waits for no motor. Servos may still be moving:
                # opening the port may have reset the board, which does not stop them.
                self._stop_observing()
            case StepBegun():
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
        known = tuple(None if each == UNREADABLE else each for each in present[: self.motors])
        self.present = known + self.present[len(known) :]

    @property
    def reply_lost(self) -> bool:
        """Return whether the last reply to a `.c` was lost, or no servo replied."""
        return self.moved is not None and set(self.moved.present) == {UNREADABLE}

    @property
    def missed_goals(self) -> dict[int, RobotError]:
        """Errors of motors that are not where they were sent, by number."""
        return {} if self.moved is None else missed_goals(self.moved.goals, self.moved.present)

    @property
    def speed_error(self) -> RobotError | None:
        """Error for speeds that servos did not accept, from the last reply to a `.v`."""
        speeds = self.speeds
        return None if speeds is None else rejected_speeds(speeds.requested, speeds.held)

    def held_speed(self, motor: int) -> int | None:
        """Return the speed that a servo reported last, or `UNREADABLE`. `None` if unknown."""
        if self.speeds is None or motor >= len(self.speeds.held):
            return None
        return self.speeds.held[motor]

    @property
    def ends_at(self) -> float | None:
        """End of the observed motion on the session's clock. `None` if there is none."""
        return None if self.moving is None else self.moving.time + self.moving.expected

    @property
    def moving_until(self) -> float | None:
        """End of any motion, observed or not, on the session's clock."""
        return self.unobserved_until if self.moving is None else self.ends_at

    @property
    def may_be_moving(self) -> bool:
        """Return whether a motion may run unobserved: no reply has shown that all motors stopped.

        This includes the time before the first reply: another host may have moved the robot.
        """
        return self.moving is None and (self.moved is None or self.reply_lost)
