"""What goes into a line session and what comes out of it.

Small, frozen and picklable, so that a session can run in a thread or in another process and
nobody above it notices the difference.
"""

from dataclasses import dataclass
from enum import Enum, auto

from trex_gui.core.session.messages import Close, Closed, Outcome, Progress
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import Command, Drive
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

# --- In ---------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class RunCommand:
    """Run one command; answered by an `Outcome` with the same `id`."""

    id: int
    command: Command[object]


@dataclass(frozen=True, slots=True)
class SetMotor:
    """What motor 1 or 2 shall do from now on; a newer one replaces one that still waits."""

    motor: int
    drive: Drive
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class SetMotors:
    """What both motors shall do from now on, in one packet: neither begins before the other."""

    drives: tuple[SetMotor, SetMotor]


@dataclass(frozen=True, slots=True)
class SetAuxiliary:
    """What the auxiliary motor shall do from now on, 0-127."""

    speed: int
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class Stop:
    """Stop every motor before anything else; answered by an `Outcome` when it is proved.

    Until an `Arm` comes every wish is dropped, and for `lockout` seconds whatever else moves a
    motor is refused.
    """

    id: int
    lockout: float = 0.0


@dataclass(frozen=True, slots=True)
class Arm:
    """The motors are armed from here on, until a `Stop`; has no outcome.

    While they are, polling keeps the board's own serial timeout from running out. Without a
    `Heartbeat` or a setpoint for `Timeouts.heartbeat` seconds the motors are stopped and
    `MotorsStopped` is reported.
    """


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """Whoever has armed the motors is still there; due every `guard.HEARTBEAT_INTERVAL` seconds.

    Attributes:
        sent: when, on the line's clock; `None`: when it is read.
    """

    sent: float | None = None


@dataclass(frozen=True, slots=True)
class Write:
    """Store parameters (key, wire value) and calibrations (channel, values).

    See `writing.write_all` for the order and for what an error does to the rest.
    Answered by an `Outcome` whose value is a tuple of `writing.Written`, one for each.
    """

    id: int
    parameters: tuple[tuple[str, int], ...] = ()
    calibrations: tuple[tuple[int, Calibration], ...] = ()


@dataclass(frozen=True, slots=True)
class Reload:
    """Read everything again; answered by `Connected`, then an `Outcome`."""

    id: int


@dataclass(frozen=True, slots=True)
class SetReconnectCandidates:
    """When the board falls silent, look for it at these settings too; has no outcome.

    Replaces what was expected before; without any settings nothing is expected. A board that
    comes back elsewhere is expected nowhere else from then on. Where a board stores its UART
    settings, this belongs before the `Write`: its power may fail right behind it.
    """

    settings: tuple[ConnectionSettings, ...]


MotorRequest = SetMotor | SetMotors | SetAuxiliary
"""What asks motors for something."""

Request = (
    RunCommand
    | MotorRequest
    | Stop
    | Arm
    | Heartbeat
    | Write
    | Reload
    | SetReconnectCandidates
    | Close
)

# --- Out --------------------------------------------------------------------------------


class ReadReason(Enum):
    """Why everything was read."""

    OPENED = auto()
    RETURNED = auto()
    MODE_CHANGED = auto()
    RELOADED = auto()

    @property
    def power_cycled(self) -> bool:
        """Whether the board's power was off since it was read before, as far as can be told."""
        return self in {ReadReason.RETURNED, ReadReason.MODE_CHANGED}


@dataclass(frozen=True, slots=True)
class Connected:
    """A board answers, and this is what it says; sent again whenever it is read anew.

    Attributes:
        echo: whether everything sent comes back: the RS-232 side of the board.
        settings: how the line is set and the board addressed now.
        may_move: whether motors were driven and no stop was proved since.
        port_rates: the baud rates that this computer's port can do; `None`: unknown.
    """

    state: DeviceState
    echo: bool
    occasion: ReadReason
    settings: ConnectionSettings
    may_move: bool = False
    port_rates: frozenset[int] | None = None


@dataclass(frozen=True, slots=True)
class NotResponding:
    """The port is there, but the board has stopped answering; the session goes on trying."""

    reason: str
    counters: Counters


@dataclass(frozen=True, slots=True)
class MotorsStopped:
    """The motors were stopped unasked, or a stop that was not proved has been at last.

    Attributes:
        reason: why nobody had to ask, for people; empty where it is the late proof of a stop.
        proved: whether the board's status proves that it has arrived.
    """

    reason: str
    confirmed: bool


@dataclass(frozen=True, slots=True)
class Batch:
    """Every sample since the last batch; at most one each display frame.

    Times are seconds on the session's clock.
    """

    samples: tuple[Sample, ...]
    counters: Counters


Report = Progress | Connected | NotResponding | MotorsStopped | Batch | Outcome | Closed
