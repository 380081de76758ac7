"""Requests to a session and reports from it. Both cross threads.

Motor messages are in `driving.requests`. Messages for all devices are in `core.session`.
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
    """Send a packet that the user typed. The `Outcome` contains the reply as `bytes`.

    While the motors are not armed, a packet that may move a motor is rejected. After a write,
    stored values are read again. Status bits that the packet cleared are reported.
    """

    id: int
    packet: RawPacket


@dataclass(frozen=True, slots=True)
class Write:
    """Store parameters and calibrations. The `Outcome` contains a `Written`.

    A new device number is rejected while motors are armed or may be moving. If the reply were lost,
    no stop would reach the board.
    """

    id: int
    parameters: tuple[tuple[str, int], ...] = ()  # (key, wire value) pairs
    calibrations: tuple[tuple[CalibrationKey, Calibration], ...] = ()
    before: DeviceState | None = None  # state known to the sender; `None` for the last reading


@dataclass(frozen=True, slots=True)
class Reload:
    """Read everything again. A `Connected` precedes the `Outcome`."""

    id: int


@dataclass(frozen=True, slots=True)
class ProbeNumber:
    """Read the signature of the board with a device number.

    The `Outcome` contains the `Signature`, or `None` if no board replies. Its error is a `BadReply`
    if more than one board replies. The request is rejected while motors are armed or may be moving.
    """

    id: int
    number: int
    attempts: int = 1


@dataclass(frozen=True, slots=True)
class SelectBoard:
    """Select and read the board with this device number.

    A `Connected` precedes the `Outcome`. Motors that may be moving are stopped first. If the stop
    is not confirmed or the board does not respond, the current board stays selected.
    """

    id: int
    number: int
    sharing: tuple[int, ...] = ()  # numbers of all boards on the line


@dataclass(frozen=True, slots=True)
class SetReconnectCandidates:
    """Set further settings to probe for a silent board. No outcome.

    These settings are dropped when the board responds at other settings. Send this request before a
    `Write` of UART settings, because the board may lose power during the write.
    """

    settings: tuple[ConnectionSettings, ...]


@dataclass(frozen=True, slots=True)
class SetWatched:
    """Set the polling rate. No outcome.

    Polling runs at the full rate while samples are watched, or while motors are armed or may be
    moving. Otherwise, it runs at a low rate.
    """

    watched: bool  # True if samples are shown or recorded
    traffic: bool = False  # True if a server must also send the bytes on its line


@dataclass(frozen=True, slots=True)
class AskLease:
    """Request the lease of a served board. A `LeaseChanged` follows.

    Lease requests have no effect on the lines of this computer.
    """


@dataclass(frozen=True, slots=True)
class HandOver:
    """Hand the lease over to a waiting user."""

    user: str


@dataclass(frozen=True, slots=True)
class TakeLease:
    """Take the lease from the current driver. Only owners may do this."""


@dataclass(frozen=True, slots=True)
class ReturnLease:
    """Return the lease. Motors that may be moving are stopped."""


LeaseRequest = AskLease | HandOver | TakeLease | ReturnLease

Job = SendPacket | Write | Reload | ProbeNumber | SelectBoard  # each has an `Outcome`

BoardRequest = Job | MotorRequest | SetReconnectCandidates


@dataclass(frozen=True, slots=True)
class ToBoard:
    """Request to one board of a group.

    A `Stop`, `Arm` or `Heartbeat` without `ToBoard` is for all boards. Such a stop has one
    `Outcome`. Any other request is for the first board.
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
    SELECTED = auto()  # another board on the line was selected

    @property
    def power_cycled(self) -> bool:
        """True if the board's power may have been off since the last reading."""
        return self not in {ReadReason.OPENED, ReadReason.RELOADED, ReadReason.SELECTED}


@dataclass(frozen=True, slots=True)
class Connected:
    """A board was read. Reported after each complete reading."""

    state: DeviceState
    echo: bool  # True if sent bytes come back, as on the RS-232 side of the board
    occasion: ReadReason
    settings: ConnectionSettings
    may_move: bool = False  # True if motors were driven and no stop was confirmed since
    port_rates: frozenset[int] | None = None  # baud rates of the port; `None` if unknown
    selection: int = 0  # id of the `SelectBoard` for this board; 0 for the first board


@dataclass(frozen=True, slots=True)
class GuardianChanged:
    is_ready: bool  # True if the guardian process can stop the motors


@dataclass(frozen=True, slots=True)
class Written:
    results: tuple[WriteResult, ...]
    state: DeviceState  # after the write
    settings: ConnectionSettings  # after the write

    @property
    def uncertain(self) -> set[str]:
        """Keys of values that the board may or may not store."""
        uncertain = {result.key for result in self.results if result.error is not None}
        if any(result.key == ParameterKey.FACTORY_RESET for result in self.results):
            uncertain |= self.state.parameters.keys()
        return uncertain


@dataclass(frozen=True, slots=True)
class ProbeProgress(Progress):
    """Progress of a diagnosis. `what` names the probed line settings."""


@dataclass(frozen=True, slots=True)
class NotResponding:
    """The board has stopped responding. The session retries."""

    reason: str
    counters: Counters
    is_network: bool = False  # True if the server does not respond: the board's state is unknown


@dataclass(frozen=True, slots=True)
class Batch:
    """Samples since the last batch. Reported at most once per display frame."""

    samples: tuple[Sample, ...]
    counters: Counters


@dataclass(frozen=True, slots=True)
class LeaseChanged:
    """Lease of a served board."""

    user: str = ""  # user of this client
    driver: str = ""  # user who has the lease, or empty
    is_mine: bool = False
    waiting: tuple[str, ...] = ()  # users who wait for the lease
    may_drive: bool = True
    may_take: bool = False


@dataclass(frozen=True, slots=True)
class SetpointsChanged:
    """Setpoints of the user who drives a served board."""

    speeds: tuple[int, int, int] = (0, 0, 0)  # motors 1, 2 and auxiliary


@dataclass(frozen=True, slots=True)
class NetworkDelay:
    """Round-trip time to the server of the board."""

    seconds: float


@dataclass(frozen=True, slots=True)
class Traffic:
    """Bytes on the line of a server."""

    events: tuple[TrafficEvent, ...]  # times on this computer's clock


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
    """Report from any board of a group except the first."""

    number: int
    report: BoardReport


Report = BoardReport | OfBoard
