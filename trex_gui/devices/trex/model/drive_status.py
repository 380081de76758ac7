"""Whether the motors follow the setpoints, why not, and what to do about it."""

from collections.abc import Callable, Collection
from dataclasses import dataclass
from enum import Enum, auto
from functools import reduce
from math import ceil
from operator import or_

from PySide6.QtCore import QCoreApplication, QObject, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import NEARLY_NEUTRAL
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.translations import Plural

_NO_ERROR = UartError(0)
_CLOSED = ConnectionState.DISCONNECTED
_FAULTS = {1: Status.MOTOR1_FAULT, 2: Status.MOTOR2_FAULT}


class DriveBlocker(Enum):
    """What decides whether the motors follow the setpoints."""

    LOST = auto()
    NO_BOARD = auto()
    OPENING = auto()
    CLOSING = auto()
    SILENT = auto()
    UNKNOWN = auto()
    NOT_SERIAL = auto()
    SAFE_START = auto()
    CHANNELS = auto()
    LOCKED = auto()
    FAULT = auto()
    TIMEOUT = auto()
    LINE_ERROR = auto()
    OVER_LIMIT = auto()
    RUNNING = auto()
    NOT_ALLOWED = auto()
    STOPPED = auto()
    NOT_ARMED = auto()

    @property
    def is_obeyed(self) -> bool:
        """Whether the motors follow the setpoints, if more slowly."""
        return self in {DriveBlocker.RUNNING, DriveBlocker.OVER_LIMIT}

    @property
    def is_alarming(self) -> bool:
        """Whether something is wrong, rather than not started."""
        return self in _ALARMING


_ALARMING = {
    DriveBlocker.LOST,
    *(DriveBlocker.SILENT, DriveBlocker.SAFE_START, DriveBlocker.FAULT, DriveBlocker.TIMEOUT),
    *(DriveBlocker.LINE_ERROR, DriveBlocker.OVER_LIMIT, DriveBlocker.LOCKED),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveInputs:
    """What the decision depends on.

    Attributes:
        may_move: whether motors were driven and no stop was confirmed since.
        lost_board: a warning about a board that may still be driven, with another one at the line.
        mode, by_serial: as the board reports; `None` while unknown.
        missing: channels that the board requires (RC mode) and that have no signal.
        faults, over_limit: motors whose driver shut down recently, or whose current passed its
            limit.
        perhaps_held: whether safe-start may hold the motors (`SafeStartWatch`).
        uart: recent UART errors.
        error_shutdown: whether the board is set to stop the motors at a UART error.
        timeout: the board's serial timeout as text; empty if it is off or unknown.
        locked_for: seconds.
    """

    link: ConnectionState = ConnectionState.CONNECTED
    may_move: bool = False
    lost_board: str = ""
    mode: Mode | None = Mode.SERIAL_RC
    by_serial: bool | None = True
    joint: bool = False
    missing: tuple[int, ...] = ()
    perhaps_held: bool = False
    faults: tuple[int, ...] = ()
    over_limit: tuple[int, ...] = ()
    uart: UartError = _NO_ERROR
    error_shutdown: bool = False
    timeout: str = ""
    locked_for: float = 0.0
    is_available: bool = True
    armed: bool = False
    stop_reason: str = ""


@dataclass(frozen=True, slots=True)
class DriveStatus:
    """What the motors do and why, and what the user can do about it, in sentences."""

    blocker: DriveBlocker
    text: str
    remedy: str = ""


_RULES: tuple[tuple[DriveBlocker, Callable[[DriveInputs], object]], ...] = (
    (DriveBlocker.LOST, lambda now: now.link is _CLOSED and (now.may_move or now.lost_board)),
    (DriveBlocker.NO_BOARD, lambda now: now.link is ConnectionState.DISCONNECTED),
    (DriveBlocker.OPENING, lambda now: now.link is ConnectionState.CONNECTING),
    (DriveBlocker.CLOSING, lambda now: now.link is ConnectionState.DISCONNECTING),
    (DriveBlocker.SILENT, lambda now: now.link is ConnectionState.NOT_RESPONDING),
    (DriveBlocker.UNKNOWN, lambda now: now.mode is None or now.by_serial is None),
    (DriveBlocker.NOT_SERIAL, lambda now: not now.by_serial and now.mode and now.mode.is_serial),
    (DriveBlocker.SAFE_START, lambda now: not now.by_serial and now.missing),
    (DriveBlocker.CHANNELS, lambda now: not now.by_serial),
    (DriveBlocker.LOCKED, lambda now: now.locked_for and not now.armed),
    (DriveBlocker.FAULT, lambda now: now.faults),
    (DriveBlocker.TIMEOUT, lambda now: now.uart & UartError.TIMEOUT),
    (DriveBlocker.LINE_ERROR, lambda now: now.uart and now.error_shutdown),
    (DriveBlocker.OVER_LIMIT, lambda now: now.over_limit and now.armed),
    (DriveBlocker.RUNNING, lambda now: now.armed),
    (DriveBlocker.NOT_ALLOWED, lambda now: not now.is_available),
    (DriveBlocker.STOPPED, lambda now: now.stop_reason),
    (DriveBlocker.NOT_ARMED, lambda _: True),
)
"""The first that applies is shown."""


def drive_status(now: DriveInputs) -> DriveStatus:
    blocker = next(blocker for blocker, applies in _RULES if applies(now))
    text, remedy = _texts(now)[blocker]
    if blocker in {DriveBlocker.RUNNING, DriveBlocker.NOT_ARMED}:
        text = " ".join([text, *_notes(now)])
    return DriveStatus(blocker, text, remedy)


def _texts(now: DriveInputs) -> dict[DriveBlocker, tuple[str, str]]:
    channels = _tr("The analog channels control the motors, not this program.")
    if now.mode is Mode.RC:
        channels = _tr("The RC channels control the motors, not this program.")
    override = _tr(
        "To drive from here, turn on the override switch (channel 5), or switch the board off, "
        "remove the mode jumper and switch it on."
    )
    if now.perhaps_held:
        held = _tr("Safe-start may be holding the motors: release all sticks.")
        channels = f"{channels} {held}"
    else:
        after_power_up = _tr("After power-up, safe-start waits until all sticks are at rest.")
        override = f"{override} {after_power_up}"
    missing = Plural.tr(
        "Safe-start keeps the motors off: no signal on required channel(s) {0}.",
        "",
        len(now.missing),
    )
    over_limit = Plural.tr(
        "Motor(s) {0} slowed down: current over the limit.",
        "",
        len(now.over_limit),
    )
    timeout = _tr("Serial timeout: the board received nothing and stopped the motors.")
    if now.timeout:
        timeout = _tr("Serial timeout: the board received nothing for {0} and stopped the motors.")
    return {
        DriveBlocker.LOST: _lost(now),
        DriveBlocker.NO_BOARD: (
            _tr("No board is connected."),
            _tr("Choose a port above and press Connect."),
        ),
        DriveBlocker.OPENING: (_tr("The board is being read."), ""),
        DriveBlocker.CLOSING: (_tr("The connection is being closed."), ""),
        DriveBlocker.SILENT: _silent(now),
        DriveBlocker.UNKNOWN: (_tr("The board has not reported yet what controls the motors."), ""),
        DriveBlocker.NOT_SERIAL: (
            _tr("The board reports that serial commands do not control the motors."),
            _tr("Switch it off and on."),
        ),
        DriveBlocker.SAFE_START: (
            missing.format(_listed(now.missing)),
            _tr("Switch the transmitter on and release its sticks."),
        ),
        DriveBlocker.CHANNELS: (channels, override),
        DriveBlocker.LOCKED: (
            _tr("Stopped. The motors are locked for {0} s.").format(ceil(now.locked_for)),
            _tr("Then Run motor arms them again."),
        ),
        DriveBlocker.FAULT: (
            _fault_text(now.faults),
            _tr("Reduce the load, check wires and battery, let it cool."),
        ),
        DriveBlocker.TIMEOUT: (
            timeout.format(now.timeout),
            "" if now.armed else _tr("Run motor arms them again."),
        ),
        DriveBlocker.LINE_ERROR: (
            _tr("Serial errors: the board stops the motors when bytes arrive corrupted."),
            _tr("Check cable and ground; UART-Error Shutdown can be turned off in Parameters."),
        ),
        DriveBlocker.OVER_LIMIT: (
            over_limit.format(_listed(now.over_limit)),
            _tr("Reduce the load, or raise the current limit in Parameters."),
        ),
        DriveBlocker.RUNNING: (
            _tr("The motors are armed: the controls on this page move them."),
            _tr("Esc stops everything."),
        ),
        DriveBlocker.NOT_ALLOWED: (_tr("The motors cannot be armed at this moment."), ""),
        DriveBlocker.STOPPED: (
            _tr("Stopped. {0}").format(now.stop_reason),
            _tr("Run motor arms the motors again."),
        ),
        DriveBlocker.NOT_ARMED: (
            _tr("Not armed: nothing is sent yet."),
            _tr("Put the robot on blocks, then press Run motor."),
        ),
    }


def _lost(now: DriveInputs) -> tuple[str, str]:
    if not now.may_move:
        return now.lost_board, ""
    text = _tr("The connection was lost: motors may still turn.")
    if not now.timeout:
        return text, _tr("Cut their power.")
    stops = _tr(
        "The board stops them {0} after the last byte it received; if not, cut their power."
    )
    return text, stops.format(now.timeout)


def _silent(now: DriveInputs) -> tuple[str, str]:
    remedy = _tr("Check its power and the cable; the stop is being repeated.")
    if not now.may_move:
        return _tr("The board does not respond."), remedy
    if now.timeout:
        stops = _tr("The board stops them {0} after the last byte it received.")
        remedy = f"{stops.format(now.timeout)} {remedy}"
    return _tr("The board does not respond: motors may still turn."), remedy


def _fault_text(faults: Collection[int]) -> str:
    text = Plural.tr(
        "Driver(s) of motor(s) {0} shut down: too hot, a short circuit, or low voltage.",
        "",
        len(faults),
    )
    return text.format(_listed(faults))


def recent_fault_text(device: Device) -> str:
    """Return which motor drivers have shut down recently, as sentences; empty if none has."""
    recent = {
        motor: entry
        for motor, bit in _FAULTS.items()
        for entry in device.errors.recent(motor)
        if entry.bit is bit
    }
    if not recent or not device.is_connected:
        return ""
    text = _fault_text(recent)
    if all(entry.is_doubtful for entry in recent.values()):
        text = _tr("{0} Doubtful: the line is noisy and has no CRC.").format(text)
    return text


def _notes(now: DriveInputs) -> list[str]:
    notes = []
    if now.mode is not None and not now.mode.is_serial:
        notes.append(_tr("Channel 5 overrides the sticks for as long as its switch is on."))
    if now.joint:
        notes.append(_tr("Joint mode: both drivers work as one motor."))
    return notes


def _listed(numbers: Collection[int]) -> str:
    return ", ".join(map(str, numbers))


def _tr(text: str) -> str:
    return QCoreApplication.translate("drive_status", text)


def drive_inputs(device: Device, *, perhaps_held: bool = False) -> DriveInputs:
    state, motors = device.state, device.motors
    recent = [entry.bit for motor in (1, 2) for entry in device.errors.recent(motor)]
    uart = reduce(or_, (bit for bit in recent if isinstance(bit, UartError)), _NO_ERROR)
    status = [bit for bit in recent if isinstance(bit, Status)]
    over_limit = {1: Status.MOTOR1_OVER_LIMIT, 2: Status.MOTOR2_OVER_LIMIT}
    stored = device.parameters.stored_of
    wire = stored(ParameterKey.SERIAL_TIMEOUT)
    return DriveInputs(
        link=device.link,
        may_move=device.may_move,
        lost_board=device.driving.lost_board,
        mode=None if state is None else state.mode,
        by_serial=device.telemetry.serial_controls,
        joint=device.is_joint,
        missing=_missing_channels(device),
        perhaps_held=perhaps_held,
        faults=tuple(motor for motor, bit in _FAULTS.items() if bit in status),
        over_limit=tuple(motor for motor, bit in over_limit.items() if bit in status),
        uart=uart,
        error_shutdown=bool(stored(ParameterKey.UART_ERROR_SHUTDOWN)),
        timeout=device.parameters.spec_of(ParameterKey.SERIAL_TIMEOUT).text(wire) if wire else "",
        locked_for=motors.locked_for,
        is_available=motors.is_available,
        armed=motors.armed,
        stop_reason=motors.stop_reason,
    )


def _missing_channels(device: Device) -> tuple[int, ...]:
    """Return the channels that the board requires (RC mode) and that have no signal."""
    state, telemetry = device.state, device.telemetry
    if telemetry.raw is None or state is None or state.mode is not Mode.RC:
        return ()
    required = device.parameters.stored_of(ParameterKey.REQUIRED_CHANNELS) or 0
    return tuple(one for one in channels_in(required) if telemetry.raw_of(one) is None)


_NOISE_COUNTS = 1  # counts that may be noise while no current flows


class SafeStartWatch(QObject):
    """Remembers whether sticks were at rest, or motors drew current, since the board came.

    Inferred: the board has no flag for safe-start. It begins at power-up and when a required
    channel falls silent, and ends when the channels that drive are near neutral, all at once;
    how near is inferred, too. Ref: TReX Jr User's Guide 4.e.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._is_over = False

        device.telemetry.updated.connect(self._on_telemetry_updated)

    @property
    def may_hold(self) -> bool:
        """Whether a channel commands a speed, no current flows and nothing shows why."""
        values, currents = self._values(), self._device.telemetry.motor_currents
        return (
            bool(values)
            and currents is not None
            and not self._is_over
            and not self._device.is_joint
        )

    @Slot()
    def _on_telemetry_updated(self) -> None:
        values = self._values()
        if not values or _missing_channels(self._device):
            self._is_over = False
        elif all(abs(value) <= NEARLY_NEUTRAL for value in values) or self._flows():
            self._is_over = True

    def _values(self) -> tuple[int, ...]:
        """Return the commands of the channels that drive; empty if none does, or unknown."""
        device = self._device
        state, remapped = device.state, device.telemetry.remapped
        if state is None or state.mode.is_serial or remapped is None:
            return ()
        first, second, third, *_ = remapped
        return (first, third) if device.is_joint else (first, second, third)

    def _flows(self) -> bool:
        state, currents = self._device.state, self._device.telemetry.motor_currents
        if state is None or currents is None:
            return False
        return max(currents) > (_NOISE_COUNTS + 0.5) * state.signature.model.current_unit
