"""What the window asks of an Aracna session, and what it is told: small frozen values, picklable.

Positions and speeds are tuples of one value a motor, motor 0 first: positions 0-1023 in the
servo's units, speeds 0-1023 (0: as fast as it can). Times are seconds of the session's clock.
"""

from dataclasses import dataclass
from enum import Enum, auto

from trex_gui.core.errors import StudioError
from trex_gui.core.session.messages import Close, Closed, Outcome
from trex_gui.core.transport.settings import PortSettings

# --- Requests -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class SetSpeeds:
    """Give every servo a speed; `Outcome` follows, its value the `SpeedsHeld`.

    One that waits is replaced by a newer one, and motions that wait with speeds get the newer.
    """

    id: int
    speeds: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Move:
    """Send every motor to a goal; `Outcome` follows when the robot has answered: `Moved`.

    With `speeds` it goes at those or not at all: they are set before where the servos are not
    known to hold them, and where one does not take them its outcome is an error.
    """

    id: int
    goals: tuple[int, ...]
    speeds: tuple[int, ...] | None = None


@dataclass(frozen=True, slots=True)
class Drag:
    """Send every motor to a goal while somebody drags: the newest that waits replaces it.

    `speeds` are those of a `Move`; where they are not taken, `DragDropped` follows.
    """

    goals: tuple[int, ...]
    speeds: tuple[int, ...] | None = None


@dataclass(frozen=True, slots=True)
class SetLimits:
    """Send no motor beyond its lowest and highest position (0-1023) from now on.

    They count for all that is sent later, asked for before or not; nothing is kept within any
    before the first.
    """

    limits: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class SetLed:
    """Switch the board's debug LED; `Outcome` follows, its value whether it is on."""

    id: int
    on: bool


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a sequence: reach `goals` in `seconds`, at speeds that make it so."""

    goals: tuple[int, ...]
    seconds: float
    name: str = ""


@dataclass(frozen=True, slots=True)
class Play:
    """Run steps one after the other; `PlayEnded` follows when it is over.

    Attributes:
        blend_in: run once, before the steps.
        steps: run `rounds` times; 0 for ever.
        blend_out: run once, after the steps, where nothing broke them off.
        time_scale: factor on every step's seconds: 2 is half as fast.
    """

    id: int
    steps: tuple[Step, ...]
    rounds: int = 1
    blend_in: tuple[Step, ...] = ()
    blend_out: tuple[Step, ...] = ()
    time_scale: float = 1.0


@dataclass(frozen=True, slots=True)
class SetTimeScale:
    """Run what is played so much slower from its next step on."""

    time_scale: float


@dataclass(frozen=True, slots=True)
class EndPlay:
    """End what is played after the current step, with its blend-out."""


@dataclass(frozen=True, slots=True)
class Halt:
    """Send nothing more: what waits and what is played is dropped.

    A motion that is under way ends by itself; nothing on this link stops it.
    """


Request = (
    SetSpeeds | SetLimits | Move | Drag | SetLed | Play | SetTimeScale | EndPlay | Halt | Close
)

# --- Reports --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class LineStats:
    """What the line has seen since the robot has answered first.

    Attributes:
        requests: commands that were sent, one on its way included.
        answers: those that were answered.
        silences: those that were not, in time.
        damaged: those whose answer got lost or was none.
        strange: lines that nobody understands.
        restarts: how often the board has said that it starts.
        slowest: the longest round trip in seconds; motions, which last as they may, left out.
    """

    requests: int = 0
    answers: int = 0
    silences: int = 0
    damaged: int = 0
    strange: int = 0
    restarts: int = 0
    slowest: float = 0.0


@dataclass(frozen=True, slots=True)
class LineStatsChanged:
    """How the line does; at most one a second, and only where something is new."""

    counters: LineStats


@dataclass(frozen=True, slots=True)
class Connected:
    """The robot has answered `.q`; `motors` is what counts from now on."""

    version: int
    motors: int
    settings: PortSettings
    restarted: bool = False


@dataclass(frozen=True, slots=True)
class Restarted:
    """The board has said `.h` of itself: what was pending is void, servos keep what they do."""

    time: float
    voided: bool


@dataclass(frozen=True, slots=True)
class Moving:
    """A `.c` went out at `time`.

    Attributes:
        expected: seconds until its answer is complete, from distance and speed.
        starts: where each motor was; `None` where that is not known.
    """

    time: float
    goals: tuple[int, ...]
    starts: tuple[int | None, ...]
    expected: float


@dataclass(frozen=True, slots=True)
class Passed:
    """The answer to a `.c` so far: `present` of the motors up to the one that is waited for."""

    time: float
    present: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Moved:
    """The answer to a `.c`: where each motor is, -1 for one that could not be read.

    All are -1 where the answer was lost on its way; where it was a `Move`, its outcome says so.
    """

    time: float
    goals: tuple[int, ...]
    present: tuple[int, ...]
    seconds: float


@dataclass(frozen=True, slots=True)
class SpeedsHeld:
    """The answer to a `.v`: what each servo holds; -1 for one that does not answer."""

    time: float
    wanted: tuple[int, ...]
    held: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class DragDropped:
    """A `Drag` was not sent, and will not be."""

    time: float
    goals: tuple[int, ...]
    error: StudioError


@dataclass(frozen=True, slots=True)
class Stuck:
    """The answer to a `.c` is late: the robot waits for `motor`; `None` where it is all silent.

    The firmware never gives up on a servo that is blocked or does not answer. Told once a
    command; `Moved` may follow after all. What waits is dropped, and no motion is taken until the
    robot has answered.
    """

    time: float
    motor: int | None


@dataclass(frozen=True, slots=True)
class NotResponding:
    """The robot has stopped answering; it is asked again and again until `Connected`."""

    reason: str


@dataclass(frozen=True, slots=True)
class StepBegun:
    """A step of what is played begins: `index` of `Play.steps`, in round `round` from 0 on.

    `index` counts within `part`, one of `in`, `steps`, `out`.
    """

    time: float
    part: str
    index: int
    round: int
    late: float


class Ending(Enum):
    """Why nothing is played any more.

    `SPEEDS`: a servo did not take the speed of a step; `MISSED`: a motor was far from its goal.
    """

    DONE = auto()
    ENDED = auto()
    HALTED = auto()
    RESTARTED = auto()
    STUCK = auto()
    SPEEDS = auto()
    MISSED = auto()
    LOST = auto()


@dataclass(frozen=True, slots=True)
class PlayEnded:
    """What was played is over; its `Outcome` follows."""

    time: float
    why: Ending


Report = (
    LineStatsChanged
    | Connected
    | Restarted
    | Moving
    | Passed
    | Moved
    | SpeedsHeld
    | DragDropped
    | Stuck
    | NotResponding
    | StepBegun
    | PlayEnded
    | Outcome
    | Closed
)
