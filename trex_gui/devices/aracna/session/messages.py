"""Requests to an Aracna session, and its reports.

Positions and speeds are tuples with one value per motor, motor 0 first. Positions are 0-1023 in the
servo's units, and speeds 0-1023 (0: unlimited). Times are seconds on the session clock.
"""

from dataclasses import dataclass
from enum import Enum

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Close, Closed, Outcome
from trex_gui.core.translation import tr_noop
from trex_gui.devices.aracna.protocol.joints import Limits

# --- Requests -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class SetSpeeds:
    """Set the servos' speeds. The outcome is a `SpeedsHeld`.

    Replaces a queued `SetSpeeds`. Queued motions with speeds use the new speeds.
    """

    id: int
    speeds: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class SetLed:
    """Switch the debug LED. The outcome is its reported state."""

    id: int
    on: bool


@dataclass(frozen=True, slots=True)
class Move:
    """Move every motor to a goal. The outcome is a `Moved`.

    Replaces a queued `Move`. With `speeds`, the motion runs at these speeds or not at all. They are
    sent first, unless the servos already have them. A rejected speed is an error. `dragged`: True
    for the moves of a drag, during which reported speeds stay valid longer.
    """

    id: int
    goals: tuple[int, ...]
    speeds: tuple[int, ...] | None = None
    dragged: bool = False


@dataclass(frozen=True, slots=True)
class SetLimits:
    """Set each motor's limits, to which later goals are clamped."""

    limits: tuple[Limits, ...]


@dataclass(frozen=True, slots=True)
class Step:
    """Step of a sequence: reach `goals` in `seconds`."""

    goals: tuple[int, ...]
    seconds: float
    name: str = ""


@dataclass(frozen=True, slots=True)
class Play:
    """Play steps `rounds` times (0: endlessly), between blend-in and blend-out.

    A `PlayEnded` follows. An aborted sequence has no blend-out. A `time_scale` of 2 halves the
    speed.
    """

    id: int
    steps: tuple[Step, ...]
    rounds: int = 1
    blend_in: tuple[Step, ...] = ()
    blend_out: tuple[Step, ...] = ()
    time_scale: float = 1.0


@dataclass(frozen=True, slots=True)
class SetTimeScale:
    """Change the time scale of the playing sequence from the next step on."""

    time_scale: float


@dataclass(frozen=True, slots=True)
class EndPlay:
    """End the playing sequence after the current step, with its blend-out."""


@dataclass(frozen=True, slots=True)
class Halt:
    """Drop queued requests and the playing sequence.

    A running motion continues to its goal, since no command stops it.
    """


Request = SetSpeeds | SetLed | SetLimits | Move | Play | SetTimeScale | EndPlay | Halt | Close

# --- Reports --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class LineStats:
    """Statistics since the robot's first reply. Changes are reported at most once a second."""

    requests: int = 0  # sent commands, including a pending command
    replies: int = 0
    timeouts: int = 0
    corrupted: int = 0  # commands with a lost or unusable reply
    unrecognized: int = 0  # lines other than the awaited reply; versions do not count
    restarts: int = 0
    slowest: float = 0.0  # longest round trip in seconds, without motions

    @property
    def finished(self) -> tuple[int, ...]:
        """Counts that a pending command does not change."""
        return self.replies, self.timeouts, self.corrupted, self.unrecognized, self.restarts


@dataclass(frozen=True, slots=True)
class Connected:
    """The robot has replied to `.q`."""

    version: int
    motors: int


@dataclass(frozen=True, slots=True)
class Restarted:
    """The board has restarted (`.h`). Pending requests are void, but servos may keep moving."""

    time: float
    voided: bool  # True if requests were pending


@dataclass(frozen=True, slots=True)
class Moving:
    """A `.c` was sent. `expected`: estimated seconds until its reply."""

    time: float
    goals: tuple[int, ...]
    starts: tuple[int | None, ...]  # `None`: unknown
    expected: float


@dataclass(frozen=True, slots=True)
class Progress:
    """Incomplete reply to a `.c`. `present`: positions received so far."""

    time: float
    present: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Moved:
    """Reply to a `.c`. `present`: positions, -1 if unreadable or lost.

    `seconds`: time from the command to the reply.
    """

    time: float
    goals: tuple[int, ...]
    present: tuple[int, ...]
    seconds: float


@dataclass(frozen=True, slots=True)
class SpeedsHeld:
    """Reply to a `.v`. `held`: speeds, -1 for a servo that did not reply."""

    time: float
    requested: tuple[int, ...]
    held: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Stuck:
    """The reply to a `.c` is late, because the robot waits for `motor`.

    The firmware waits forever for a servo that is blocked or does not respond. A `Moved` may still
    follow, or another `Stuck` for a later motor. Queued requests are dropped. Requests that need an
    idle robot are rejected until it has replied.
    """

    time: float
    motor: int | None  # `None`: nothing has arrived


@dataclass(frozen=True, slots=True)
class NotResponding:
    """The robot does not respond. It is queried until `Connected`."""

    time: float
    error: StudioError | None = None


@dataclass(frozen=True, slots=True)
class StepStarted:
    """A step has started, `late` seconds behind schedule.

    `part`: `in`, `steps` or `out`. `index` (within the part) and `round` count from 0.
    """

    time: float
    part: str
    index: int
    round: int
    late: float


class Ending(Enum):
    """Reason why a sequence has ended. The value is a sentence for the user."""

    DONE = tr_noop("Played to the end.")
    ENDED = tr_noop("The sequence ended after the current step.")
    HALTED = tr_noop("The sequence was stopped.")
    RESTARTED = tr_noop("The sequence was aborted: the board has restarted.")
    STUCK = tr_noop("The sequence was aborted: the robot is waiting for a motor.")
    SPEEDS = tr_noop("The sequence was aborted: a motor did not accept its speed.")
    MISSED = tr_noop("The sequence was aborted: a motor was far from its goal.")
    LOST = tr_noop("The sequence was aborted: the robot does not respond.")


@dataclass(frozen=True, slots=True)
class PlayEnded:
    """The sequence has ended. Its outcome follows."""

    time: float
    ending: Ending


Report = (
    LineStats
    | Connected
    | Restarted
    | Moving
    | Progress
    | Moved
    | SpeedsHeld
    | Stuck
    | NotResponding
    | StepStarted
    | PlayEnded
    | Outcome
    | Closed
)
