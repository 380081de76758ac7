"""What is known of the robot from what its session reports; no Qt, no clock of its own."""

from collections import deque
from dataclasses import dataclass, field

from trex_gui.devices.aracna.session.messages import (
    Connected,
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

TOLERANCE = 12
"""Position units between goal and reply that are no difference: 3.5 degrees.

A servo stops within its compliance margin, some units off; how many is not documented for this
robot. Its own self-test took 50 for a failure.
"""

UNREADABLE = -1
"""What the firmware reports of a servo that did not answer."""


@dataclass(frozen=True, slots=True)
class Missed:
    """A motor that is not where it was sent.

    Attributes:
        present: where it is; `UNREADABLE` where it did not answer.
    """

    motor: int
    goal: int
    present: int

    @property
    def unreadable(self) -> bool:
        """Whether the servo did not answer."""
        return self.present == UNREADABLE


@dataclass(frozen=True, slots=True)
class SpeedRefused:
    """A speed that a servo did not take; `held` is `UNREADABLE` where it did not answer."""

    motor: int
    wanted: int
    held: int

    @property
    def unreadable(self) -> bool:
        """Whether the servo did not answer."""
        return self.held == UNREADABLE


@dataclass(frozen=True, slots=True)
class PlayState:
    """What is being played: `step` of `steps` (from 0) in `part` and `round`; `name` of the step.

    `step` is `None` before the first one has begun; `rounds` is 0 for ever.
    """

    steps: int
    rounds: int
    part: str = ""
    step: int | None = None
    round: int = 0
    name: str = ""
    late: float = 0.0


class Rate:
    """How many commands a second were answered lately: at most the last ten count."""

    def __init__(self) -> None:
        self._times: deque[float] = deque(maxlen=10)

    def note(self, time: float) -> None:
        """Count a reply; a pause of a second begins anew."""
        if self._times and time > self._times[-1] + 1:
            self._times.clear()
        self._times.append(time)

    def forget(self) -> None:
        """Begin anew."""
        self._times.clear()

    @property
    def per_second(self) -> float | None:
        """The rate; `None` before there are three replies."""
        if len(self._times) < 3:
            return None
        span = self._times[-1] - self._times[0]
        return (len(self._times) - 1) / span if span > 0 else None


@dataclass(slots=True)
class RobotState:
    """The newest of everything; nothing is known at first.

    Attributes:
        present: where each motor was last reported; `None` where that is not known.
        goals: what was sent last.
        moving: the `.c` that is not answered yet.
        moved: the last complete answer.
        waited_for: the motor whose turn it is in the answer that is coming.
        unsure: whether what was sent last may still go on, unseen.
        left_until: when a motion that nobody watches any more should end, on the session's clock;
            `None` where there is none. It stays when it is over: only its time tells that.
        speeds: the last `.v` and what the servos hold; `None` where neither is known.
    """

    motors: int
    present: list[int | None] = field(default_factory=list)
    goals: tuple[int, ...] | None = None
    moving: Moving | None = None
    moved: Moved | None = None
    waited_for: int = 0
    stuck: Stuck | None = None
    unsure: bool = False
    left_until: float | None = None
    speeds: SpeedsHeld | None = None
    play: Play | None = None
    playing: PlayState | None = None

    def __post_init__(self) -> None:
        """Know of no position."""
        self.present = [None] * self.motors

    def take(self, report: object) -> None:
        """Follow a report of the session."""
        match report:
            case Moving(goals=goals):
                self.moving, self.goals = report, goals
                self.waited_for, self.stuck, self.moved = 0, None, None
                self.unsure, self.left_until = False, None  # every motor has a new goal
            case Passed(present=present):
                self._note(present)
                self.waited_for = min(len(present), self.motors - 1)
                if self.stuck is not None and self.stuck.motor != self.waited_for:
                    self.stuck = None  # it was late, and came after all
            case Moved():
                self._arrive(report)
            case Stuck():
                self.stuck = report
            case SpeedsHeld():
                self.speeds = report
            case Restarted() | NotResponding():
                self._lose_sight()
            case Connected():
                # What answers `.q` waits for no motor. Servos may move all the same: opening the
                # port may have reset the board, which they do not notice.
                self._leave_running()
            case StepBegun() if self.play is not None:
                self.playing = _place(self.play, report)
            case PlayEnded():
                self.play, self.playing = None, None
            case _:
                pass

    def _lose_sight(self) -> None:
        """Know no position: nobody saw what the servos did meanwhile, nor who turned them."""
        self.present = [None] * self.motors
        self._leave_running()
        self.moved, self.speeds = None, None
        self.unsure = self.goals is not None

    def _leave_running(self) -> None:
        """Watch the motion no longer; that it was begun counts until its time is over."""
        if self.moving is not None:
            self.left_until, self.unsure = self.ends_at, True
        self.moving, self.stuck = None, None

    def _arrive(self, moved: Moved) -> None:
        self._note(moved.present)
        self.moved, self.goals = moved, moved.goals
        if self.is_lost:  # the answer, or all servos: none of them says that it stands
            self._leave_running()
        else:
            self.moving, self.stuck = None, None
            self.unsure, self.left_until = False, None

    def _note(self, present: tuple[int, ...]) -> None:
        for motor, position in enumerate(present[: self.motors]):
            self.present[motor] = None if position == UNREADABLE else position

    @property
    def is_lost(self) -> bool:
        """Whether the last answer says of no motor where it is: it was lost, or none answers."""
        return self.moved is not None and set(self.moved.present) == {UNREADABLE}

    @property
    def no_servo_answers(self) -> bool:
        """Whether the last `.v` was answered by no servo."""
        return self.speeds is not None and set(self.speeds.held) == {UNREADABLE}

    @property
    def missed(self) -> tuple[Missed, ...]:
        """The motors that the last complete answer shows elsewhere than they were sent."""
        if self.moved is None:
            return ()
        pairs = enumerate(zip(self.moved.goals, self.moved.present, strict=False))
        return tuple(
            Missed(motor, goal, present)
            for motor, (goal, present) in pairs
            if present == UNREADABLE or abs(goal - present) > TOLERANCE
        )

    @property
    def speeds_refused(self) -> tuple[SpeedRefused, ...]:
        """The speeds of the last `.v` that a servo did not take."""
        if self.speeds is None:
            return ()
        pairs = enumerate(zip(self.speeds.requested, self.speeds.held, strict=False))
        return tuple(
            SpeedRefused(motor, wanted, held) for motor, (wanted, held) in pairs if wanted != held
        )

    def held(self, motor: int) -> int | None:
        """Return the speed that a servo reported last, `UNREADABLE` from none; `None`: unknown."""
        if self.speeds is None or motor >= len(self.speeds.held):
            return None
        return self.speeds.held[motor]

    @property
    def ends_at(self) -> float | None:
        """When the running motion should end, on the session's clock; `None`: none runs."""
        return None if self.moving is None else self.moving.time + self.moving.expected

    @property
    def goes_on_until(self) -> float | None:
        """When what moves should end, watched or not, on the session's clock.

        `None`: nothing that was sent moves any more.
        """
        return self.left_until if self.moving is None else self.ends_at

    @property
    def may_move_unseen(self) -> bool:
        """Whether no motion runs that is watched, and no answer has said that all motors stand.

        So it is before the first answer: whoever drove the robot before may have left it moving.
        """
        return self.moving is None and (self.moved is None or self.is_lost)


def _place(play: Play, begun: StepBegun) -> PlayState:
    steps = {"in": play.blend_in, "out": play.blend_out}.get(begun.part, play.steps)
    name = steps[begun.index].name if begun.index < len(steps) else ""
    return PlayState(
        len(steps), play.rounds, begun.part, begun.index, begun.round, name, begun.late
    )
