"""Requests to a line session and its reports, which cross threads.

Messages that all devices share are in `core.session`, messages for motors in `driving.requests`.
"""

from dataclasses import dataclass
from enum import Enum, auto

from trex_gui.core.session import Close, Closed, Outcome, Progress
from trex_gui.core.transport.traffic import TrafficEvent
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.driving.requests import MotorReport, MotorRequest
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.protocol.raw_packets import RawPacket


@dataclass(frozen=True, slots=True)
class SendPacket:
    """Send a packet that the user typed, as it is. The value of its `Outcome` is the `bytes` reply.

    A packet that may move a motor is rejected unless the motors are armed. Values that the packet
    stores are read again, and status bits that it clears are reported.
    """

    id: int
    packet: RawPacket


@dataclass(frozen=True, slots=True)
class Write:
    """Store parameters (key, wire value) and calibrations (key, values).

    The value of the `Outcome` is a `Written`; see `writing.write_all`. `before` is the state known
    to the sender, `None` for the last read state. A new device number is rejected while motors are
    armed or may be moving: if its reply were lost, no stop would reach the board.
    """

    id: int
    parameters: tuple[tuple[str, int], ...] = ()
    calibrations: tuple[tuple[CalibrationKey, Calibration], ...] = ()
    before: DeviceState | None = None


@dataclass(frozen=True, slots=True)
class Reload:
    """Read everything again. A `Connected` is reported before its `Outcome`."""

    id: int


@dataclass(frozen=True, slots=True)
class ProbeNumber:
    """Find out which board has a device number, by its signature. Nothing is changed.

    The value of the `Outcome` is the `Signature`, or `None` if no board replies. Its error is a
    `BadReply` if several reply at once. Rejected while motors are armed or may be moving.
    """

    id: int
    number: int
    attempts: int = 1


@dataclass(frozen=True, slots=True)
class SelectBoard:
    """Address the board with this device number from now on, and read everything from it.

    A `Connected` is reported before the `Outcome`. Motors that may be moving are stopped first;
    without a confirmation, or if the board does not respond, the present board stays selected.
    `sharing` are the numbers of all boards known on the line: commands without a number reached
    every one of them.
    """

    id: int
    number: int
    sharing: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class SetReconnectCandidates:
    """Look for a silent board at these settings too. Has no outcome.

    Replaces earlier candidates, and is dropped when the board responds at other settings. Send it
    before a `Write` of UART settings: the power of the board may fail right after it.
    """

    settings: tuple[ConnectionSettings, ...]


@dataclass(frozen=True, slots=True)
class SetWatched:
    """Poll at full rate, or slowly while nothing shows or records samples. Has no outcome.

    While motors may be moving the rate is full in either case. `traffic`: a server also sends the
    bytes on its line. A line of this computer is logged where it is opened.
    """

    watched: bool
    traffic: bool = False


@dataclass(frozen=True, slots=True)
class AskLease:
    """Drive a board that is served to several clients, as soon as possible.

    A `LeaseChanged` follows. Lease requests have no effect at a line of this computer.
    """


@dataclass(frozen=True, slots=True)
class HandOver:
    """Let the waiting client of this user drive in place of the sender."""

    user: str


@dataclass(frozen=True, slots=True)
class TakeLease:
    """Drive in place of the current driver. Only owners may do so."""


@dataclass(frozen=True, slots=True)
class ReturnLease:
    """Stop driving. Motors that may be moving are stopped."""


LeaseRequest = AskLease | HandOver | TakeLease | ReturnLease

Job = SendPacket | Write | Reload | ProbeNumber | SelectBoard
"""Requests that are served in their order; each has an `Outcome`."""

BoardRequest = Job | MotorRequest | SetReconnectCandidates


@dataclass(frozen=True, slots=True)
class ToBoard:
    """A request for one of the boards that are driven together, by its number.

    A `Stop`, `Arm` or `Heartbeat` without `ToBoard` is for all boards. The `Outcome` of such a stop
    is reported once all boards have an outcome. Any other request is for the first board.
    """

    number: int
    request: BoardRequest


Request = BoardRequest | ToBoard | SetWatched | LeaseRequest | Close


class ReadReason(Enum):
    OPENED = auto()
    RETURNED = auto()
    RESTARTED = auto()
    SETTING_CHANGED = auto()  # the board was restarted, or another program wrote to it
    RELOADED = auto()
    SELECTED = auto()  # another board on the line is addressed from now on

    @property
    def power_cycled(self) -> bool:
        """True if the board's power may have been off since it was read before."""
        return self not in {ReadReason.OPENED, ReadReason.RELOADED, ReadReason.SELECTED}


@dataclass(frozen=True, slots=True)
class Connected:
    """A board responds and was read. Reported again whenever everything is read."""

    state: DeviceState
    echo: bool  # whether everything sent comes back, as on the RS-232 side of the board
    occasion: ReadReason
    settings: ConnectionSettings  # present settings of the line, and address of the board
    may_move: bool = False  # whether motors were driven and no stop was confirmed since
    # The baud rates that this computer's port supports; `None`: unknown
    port_rates: frozenset[int] | None = None
    # Id of the `SelectBoard` that selected this board; 0 for the board at the line's opening
    selection: int = 0


@dataclass(frozen=True, slots=True)
class GuardianChanged:
    """State of the guardian process, which stops the motors if this program fails."""

    is_ready: bool


@dataclass(frozen=True, slots=True)
class Written:
    """The result of a `Write`: what the board stores now, and how it is addressed."""

    results: tuple[WriteResult, ...]
    state: DeviceState
    settings: ConnectionSettings

    @property
    def uncertain(self) -> set[str]:
        """Keys of values that the board may or may not store."""
        uncertain = {result.key for result in self.results if result.error is not None}
        if any(result.key == ParameterKey.FACTORY_RESET for result in self.results):
            uncertain |= self.state.parameters.keys()
        return uncertain


@dataclass(frozen=True, slots=True)
class ProbeProgress(Progress):
    """Progress of the search for the reason why no board responds. `what` are line settings."""


@dataclass(frozen=True, slots=True)
class NotResponding:
    """The board has stopped responding. The session keeps trying.

    `is_network`: nothing is known of the board, since its server does not respond.
    """

    reason: str
    counters: Counters
    is_network: bool = False


@dataclass(frozen=True, slots=True)
class Batch:
    """Every sample since the last batch. At most one each display frame, fewer if unwatched."""

    samples: tuple[Sample, ...]
    counters: Counters


@dataclass(frozen=True, slots=True)
class LeaseChanged:
    """Driver of a board that is served to several clients, and users who wait to drive."""

    user: str = ""  # the user of this client
    driver: str = ""  # the user who drives; empty: nobody
    is_mine: bool = False
    waiting: tuple[str, ...] = ()  # users
    may_drive: bool = True
    may_take: bool = False


@dataclass(frozen=True, slots=True)
class SetpointsChanged:
    """Speeds of motors 1, 2 and 3 (auxiliary) that the driver of a served board has set."""

    speeds: tuple[int, int, int] = (0, 0, 0)


@dataclass(frozen=True, slots=True)
class NetworkDelay:
    """Round trip of a message to the server of the board, in seconds."""

    seconds: float


@dataclass(frozen=True, slots=True)
class Traffic:
    """Bytes on the line of a server, on the clock of this computer."""

    events: tuple[TrafficEvent, ...]


BoardReport = (
    Progress
    | Connected
    | GuardianChanged
    | NotResponding
    | MotorReport
    | Batch
    | LeaseChanged
    | SetpointsChanged
    | NetworkDelay
    | Traffic
    | Outcome
    | Closed
)


@dataclass(frozen=True, slots=True)
class OfBoard:
    """A report of one of the boards that are driven together, but not of the first one."""

    number: int
    report: BoardReport


Report = BoardReport | OfBoard
