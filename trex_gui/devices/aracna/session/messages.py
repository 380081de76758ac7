"""Requests to an Aracna session, and its reports, as small frozen values.

Positions and speeds are tuples with one value for each motor, motor 0 first: positions 0-1023 in
the servo's units, speeds 0-1023 (0: unlimited). Times are seconds on the session's clock.
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
    """Set every servo's speed. The value of its `Outcome` is the `SpeedsHeld`.

    It replaces a queued `SetSpeeds`. Queued motions with speeds use the new speeds.
    """

    id: int
    speeds: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class SetLed:
    """Switch the board's debug LED. The value of its `Outcome` is whether it is on afterwards."""

    id: int
    on: bool


@dataclass(frozen=True, slots=True)
class Move:
    """Move every motor to a goal, in place of a queued `Move`. Its `Outcome` has the `Moved`.

    With `speeds`, the motion runs at these speeds or not at all. They are sent first unless the
    servos are known to hold them. The outcome is an error if a servo does not accept its speed.
    `dragged`: one of many moves in a row, which do not send speeds that are still trusted.
    """

    id: int
    goals: tuple[int, ...]
    speeds: tuple[int, ...] | None = None
    dragged: bool = False


@dataclass(frozen=True, slots=True)
class SetLimits:
    """Crop all goals sent from now on to the limits of each motor."""

    limits: tuple[Limits, ...]


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a sequence: reach `goals` in `seconds`, at suitable speeds."""

    goals: tuple[int, ...]
    seconds: float
    name: str = ""


@dataclass(frozen=True, slots=True)
class Play:
    """Play steps `rounds` times (0: endless), between the blends. `PlayEnded` follows.

    If the steps are aborted, there is no blend-out. `time_scale` 2 is half as fast.
    """

    id: int
    steps: tuple[Step, ...]
    rounds: int = 1
    blend_in: tuple[Step, ...] = ()
    blend_out: tuple[Step, ...] = ()
    time_scale: float = 1.0


@dataclass(frozen=True, slots=True)
class SetTimeScale:
    """Change the time scale of the playing sequence from its next step on."""

    time_scale: float


@dataclass(frozen=True, slots=True)
class EndPlay:
    """End the playing sequence after the current step, with its blend-out."""


@dataclass(frozen=True, slots=True)
class Halt:
    """Send nothing more: drop queued requests and the playing sequence.

    A running motion continues to its goal. No command stops it.
    """


Request = SetSpeeds | SetLed | SetLimits | Move | Play | SetTimeScale | EndPlay | Halt | Close

# --- Reports --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class LineStats:
    """Counts since the robot's first reply. Reported once a second at most, when they change."""

    requests: int = 0  # sent commands, including a pending command
    replies: int = 0
    timeouts: int = 0
    corrupted: int = 0  # commands whose reply was lost or unusable
    unrecognized: int = 0  # lines that are not replies of an Aracna
    restarts: int = 0
    slowest: float = 0.0  # longest round trip in seconds, without motions

    @property
    def finished(self) -> tuple[int, ...]:
        """Counts that do not include a pending command."""
        return self.replies, self.timeouts, self.corrupted, self.unrecognized, self.restarts


@dataclass(frozen=True, slots=True)
class Connected:
    """The robot has answered `.q`. `motors` is valid from now on."""

    version: int
    motors: int


@dataclass(frozen=True, slots=True)
class Restarted:
    """The board has restarted (`.h`): pending requests are void, but servos continue."""

    time: float
    voided: bool


@dataclass(frozen=True, slots=True)
class Moving:
    """A `.c` was sent. Its reply should take `expected` seconds. Unknown starts are `None`."""

    time: float
    goals: tuple[int, ...]
    starts: tuple[int | None, ...]
    expected: float


@dataclass(frozen=True, slots=True)
class Passed:
    """The reply to a `.c` so far. `present` has the motors before the awaited motor."""

    time: float
    present: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Moved:
    """The reply to a `.c`. `present` has the position of each motor, -1 if unreadable or lost."""

    time: float
    goals: tuple[int, ...]
    present: tuple[int, ...]
    seconds: float


@dataclass(frozen=True, slots=True)
class SpeedsHeld:
    """The reply to a `.v`. `held` has the speed of each servo, -1 if it does not respond."""

    time: float
    requested: tuple[int, ...]
    held: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Stuck:
    """The reply to a `.c` is late: the robot waits for `motor`. `None` if nothing has arrived.

    The firmware waits forever for a servo that is blocked or does not respond. Reported once
    for each command; `Moved` may still follow. Queued requests are dropped, and requests
    that need an idle robot are rejected until it has answered.
    """

    time: float
    motor: int | None


@dataclass(frozen=True, slots=True)
class NotResponding:
    """The robot has stopped responding. It is queried until `Connected`."""

    time: float
    error: StudioError | None = None


@dataclass(frozen=True, slots=True)
class StepBegun:
    """A step starts, `late` seconds behind schedule.

    `index` within `part` (`in`, `steps` or `out`) and `round` count from 0.
    """

    time: float
    part: str
    index: int
    round: int
    late: float


class Ending(Enum):
    """End of a sequence. The value is the sentence for the user."""

    DONE = tr_noop("Played to the end.")
    ENDED = tr_noop("The sequence has ended after its step.")
    HALTED = tr_noop("The sequence was stopped.")
    RESTARTED = tr_noop("The sequence was aborted: the board has restarted.")
    STUCK = tr_noop("The sequence was aborted: the robot waits for a motor.")
    SPEEDS = tr_noop("The sequence was aborted: a motor did not accept its speed.")
    MISSED = tr_noop("The sequence was aborted: a motor was far from its goal.")
    LOST = tr_noop("The sequence was aborted: the robot does not respond.")


@dataclass(frozen=True, slots=True)
class PlayEnded:
    """The sequence has ended. Its `Outcome` follows."""

    time: float
    why: Ending


Report = (
    LineStats
    | Connected
    | Restarted
    | Moving
    | Passed
    | Moved
    | SpeedsHeld
    | Stuck
    | NotResponding
    | StepBegun
    | PlayEnded
    | Outcome
    | Closed
)
