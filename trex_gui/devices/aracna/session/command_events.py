"""A command that is on its way, and all that can come of it."""

from dataclasses import dataclass

from trex_gui.core.errors import StudioError
from trex_gui.devices.aracna.protocol.replies import Led, Positions, Speeds, Version


@dataclass(frozen=True, slots=True)
class Sent:
    """A command that is on its way.

    Attributes:
        letter: which: `q`, `v`, `c` or `l`.
        values: one a motor for `.v` and `.c`, else empty.
        sent: when, on the line's clock.
        seconds: until its answer is late.
    """

    letter: str
    values: tuple[int, ...]
    sent: float
    seconds: float


@dataclass(frozen=True, slots=True)
class Answered:
    """Its answer is there."""

    asked: Sent
    reply: Version | Speeds | Positions | Led
    time: float


@dataclass(frozen=True, slots=True)
class Passing:
    """The answer to a `.c` so far; the next motor is the one that is waited for."""

    asked: Sent
    present: tuple[int, ...]
    time: float


@dataclass(frozen=True, slots=True)
class LateReply:
    """The answer to a `.c` is late; `motor` is waited for, `None` where nothing has come."""

    asked: Sent
    motor: int | None
    time: float


@dataclass(frozen=True, slots=True)
class Lost:
    """No answer will come any more.

    `free` says that the robot has answered a `.q` behind it: it is there, and idle.
    """

    asked: Sent
    error: StudioError
    free: bool
    time: float


@dataclass(frozen=True, slots=True)
class Voided:
    """The firmware has started: what was on its way (`None`: nothing) is not answered."""

    asked: Sent | None
    time: float


News = Answered | Passing | LateReply | Lost | Voided
