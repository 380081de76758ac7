"""The one reason why the motors follow the setpoints or do not, and what to do about it."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, auto
from math import ceil

from PySide6.QtCore import QCoreApplication, QObject, Slot

from trex_gui.devices.trex.calibration.proof import NEARLY_NEUTRAL
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, Status, UartError, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.connection_state import ConnectionState

_NO_ERROR = UartError(0)


class DriveBlocker(Enum):
    """What decides whether the motors follow the setpoints; the first that applies is shown."""

    NO_BOARD = auto()
    OPENING = auto()
    CLOSING = auto()
    SILENT = auto()
    UNKNOWN = auto()
    NOT_SERIAL = auto()
    SAFE_START = auto()
    CHANNELS_HELD = auto()
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
    *(DriveBlocker.SILENT, DriveBlocker.SAFE_START, DriveBlocker.FAULT, DriveBlocker.TIMEOUT),
    *(DriveBlocker.LINE_ERROR, DriveBlocker.OVER_LIMIT, DriveBlocker.LOCKED),
}
_BY_LINK = {
    ConnectionState.DISCONNECTED: DriveBlocker.NO_BOARD,
    ConnectionState.CONNECTING: DriveBlocker.OPENING,
    ConnectionState.DISCONNECTING: DriveBlocker.CLOSING,
    ConnectionState.NOT_RESPONDING: DriveBlocker.SILENT,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveInputs:
    """What the decision depends on.

    Attributes:
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


def find_blocker(now: DriveInputs) -> DriveBlocker:
    """Return what matters most."""
    if now.link is not ConnectionState.CONNECTED:
        return _BY_LINK[now.link]
    if now.mode is None or now.by_serial is None:
        return DriveBlocker.UNKNOWN
    if not now.by_serial:
        if now.mode.is_serial:
            return DriveBlocker.NOT_SERIAL
        if now.missing:
            return DriveBlocker.SAFE_START
        return DriveBlocker.CHANNELS_HELD if now.perhaps_held else DriveBlocker.CHANNELS
    if now.locked_for and not now.armed:
        return DriveBlocker.LOCKED
    return _latched(now) or _by_arming(now)


def _latched(now: DriveInputs) -> DriveBlocker | None:
    """Return what the board latched recently; a limit only matters while armed."""
    if now.faults:
        return DriveBlocker.FAULT
    if now.uart & UartError.TIMEOUT:
        return DriveBlocker.TIMEOUT
    if now.uart and now.error_shutdown:
        return DriveBlocker.LINE_ERROR
    return DriveBlocker.OVER_LIMIT if now.over_limit and now.armed else None


def _by_arming(now: DriveInputs) -> DriveBlocker:
    if now.armed:
        return DriveBlocker.RUNNING
    if not now.is_available:
        return DriveBlocker.NOT_ALLOWED
    return DriveBlocker.STOPPED if now.stop_reason else DriveBlocker.NOT_ARMED


def drive_inputs(device: Device, *, perhaps_held: bool = False) -> DriveInputs:
    """Gather the inputs from the models, and what was seen of safe-start."""
    state, motors, telemetry = device.state, device.motors, device.telemetry
    recent = {motor: device.errors.recent(motor) for motor in (1, 2)}
    bits = [entry.bit for entries in recent.values() for entry in entries]
    uart = _NO_ERROR
    for bit in bits:
        if isinstance(bit, UartError):
            uart |= bit
    stored = device.parameters.stored_of
    wire = stored(ParameterKey.SERIAL_TIMEOUT)
    required = stored(ParameterKey.REQUIRED_CHANNELS) or 0
    missing: tuple[int, ...] = ()
    if telemetry.raw is not None and state is not None and state.mode is Mode.RC:
        missing = tuple(
            channel
            for channel in CHANNELS
            if channel in channels_in(required) and telemetry.raw_of(channel) is None
        )
    by_serial = telemetry.serial_controls
    if by_serial is None and state is not None:
        by_serial = state.serial_controls
    return DriveInputs(
        link=device.link,
        mode=None if state is None else state.mode,
        by_serial=by_serial,
        joint=device.is_joint,
        missing=missing,
        perhaps_held=perhaps_held,
        faults=_motors_with(bits, {1: Status.MOTOR1_FAULT, 2: Status.MOTOR2_FAULT}),
        over_limit=_motors_with(bits, {1: Status.MOTOR1_OVER_LIMIT, 2: Status.MOTOR2_OVER_LIMIT}),
        uart=uart,
        error_shutdown=bool(stored(ParameterKey.UART_ERROR_SHUTDOWN)),
        timeout=device.parameters.spec_of(ParameterKey.SERIAL_TIMEOUT).text(wire) if wire else "",
        locked_for=motors.locked_for,
        is_available=motors.is_available,
        armed=motors.armed,
        stop_reason=motors.stop_reason,
    )


def _motors_with(bits: Sequence[Status | UartError], wanted: dict[int, Status]) -> tuple[int, ...]:
    seen = [bit for bit in bits if isinstance(bit, Status)]
    return tuple(motor for motor, bit in wanted.items() if bit in seen)


# --- Text -------------------------------------------------------------------------------


def status_text(now: DriveInputs) -> tuple[str, str]:
    """Return what the motors do and why, and what the user can do about it; in sentences."""
    blocker = find_blocker(now)
    return _text(blocker, now), _remedy(blocker, now)


def _text(blocker: DriveBlocker, now: DriveInputs) -> str:
    match blocker:
        case DriveBlocker.SAFE_START:
            text = _tr(
                "Safe-start keeps the motors off: channel {0} is required but has no signal."
            )
            if len(now.missing) > 1:
                text = _tr(
                    "Safe-start keeps the motors off: channels {0} are required but have no signal."
                )
            return text.format(", ".join(map(str, now.missing)))
        case DriveBlocker.CHANNELS | DriveBlocker.CHANNELS_HELD:
            return _channels_text(now)
        case DriveBlocker.LOCKED:
            return _tr("Stopped. The motors are locked for {0} s.").format(ceil(now.locked_for))
        case DriveBlocker.FAULT:
            text = _tr(
                "Motor {0} has no drive: its driver shut down (too hot, a short circuit, or low "
                "voltage)."
            )
            if len(now.faults) > 1:
                text = _tr(
                    "Both motors have no drive: their drivers shut down (too hot, a short circuit, "
                    "or low voltage)."
                )
            return text.format(*now.faults)
        case DriveBlocker.TIMEOUT if now.timeout:
            text = _tr("Serial timeout: the board received nothing for {0} and stopped the motors.")
            return text.format(now.timeout)
        case DriveBlocker.OVER_LIMIT:
            text = _tr("Motor {0} is slowed down: its current passed the limit.")
            if len(now.over_limit) > 1:
                text = _tr("Both motors are slowed down: their currents passed the limit.")
            return text.format(*now.over_limit)
        case DriveBlocker.STOPPED:
            return _tr("Stopped. {0}").format(now.stop_reason)
        case DriveBlocker.RUNNING | DriveBlocker.NOT_ARMED:
            return " ".join([_sentence(blocker), *_notes(now)])
        case _:
            return _sentence(blocker)


def _sentence(blocker: DriveBlocker) -> str:
    return {
        DriveBlocker.NO_BOARD: _tr("No board is connected."),
        DriveBlocker.OPENING: _tr("The board is being read."),
        DriveBlocker.CLOSING: _tr("The connection is being closed."),
        DriveBlocker.SILENT: _tr("The board does not answer."),
        DriveBlocker.UNKNOWN: _tr("The board has not reported yet what controls the motors."),
        DriveBlocker.NOT_SERIAL: _tr(
            "The board reports that serial commands do not control the motors."
        ),
        DriveBlocker.TIMEOUT: _tr(
            "Serial timeout: the board received nothing and stopped the motors."
        ),
        DriveBlocker.LINE_ERROR: _tr(
            "Serial errors: the board stops the motors when bytes arrive corrupted."
        ),
        DriveBlocker.RUNNING: _tr("The motors are armed: the controls on this page move them."),
        DriveBlocker.NOT_ALLOWED: _tr("The motors cannot be armed at this moment."),
        DriveBlocker.NOT_ARMED: _tr("Not armed: nothing is sent yet."),
    }[blocker]


def _channels_text(now: DriveInputs) -> str:
    if now.perhaps_held:
        if now.mode is Mode.RC:
            return _tr(
                "The RC channels control the motors, not this program; safe-start may be holding "
                "the motors: let the sticks rest once."
            )
        return _tr(
            "The analog channels control the motors, not this program; safe-start may be holding "
            "the motors: let the sticks rest once."
        )
    if now.mode is Mode.RC:
        return _tr("The RC channels control the motors, not this program.")
    return _tr("The analog channels control the motors, not this program.")


def _remedy(blocker: DriveBlocker, now: DriveInputs) -> str:
    if blocker is DriveBlocker.TIMEOUT and now.armed:
        return ""
    serial_control = _tr(
        "To drive from here, turn on the override switch (channel 5), or switch the board off, "
        "take the mode jumper off and switch it on."
    )
    return {
        DriveBlocker.NO_BOARD: _tr("Choose a port above."),
        DriveBlocker.SILENT: _tr("Check its power and the cable; the stop is being repeated."),
        DriveBlocker.NOT_SERIAL: _tr("Switch it off and on."),
        DriveBlocker.SAFE_START: _tr("Switch the transmitter on and let go of its sticks."),
        DriveBlocker.CHANNELS_HELD: serial_control,
        DriveBlocker.CHANNELS: " ".join(
            [serial_control, _tr("After power-up safe-start waits for sticks at rest.")]
        ),
        DriveBlocker.LOCKED: _tr("Then Run motor arms them again."),
        DriveBlocker.FAULT: _tr("Reduce the load, check wires and battery, let it cool."),
        DriveBlocker.TIMEOUT: _tr("Run motor arms them again."),
        DriveBlocker.LINE_ERROR: _tr(
            "Check cable and ground; UART-Error Shutdown can be turned off in Parameters."
        ),
        DriveBlocker.OVER_LIMIT: _tr("Reduce the load, or raise the current limit in Parameters."),
        DriveBlocker.RUNNING: _tr("Esc stops everything."),
        DriveBlocker.STOPPED: _tr("Run motor arms the motors again."),
        DriveBlocker.NOT_ARMED: _tr("Put the robot on blocks, then press Run motor."),
    }.get(blocker, "")


def _notes(now: DriveInputs) -> list[str]:
    notes = []
    if now.mode is not None and not now.mode.is_serial:
        notes.append(_tr("Channel 5 overrides the sticks for as long as its switch is on."))
    if now.joint:
        notes.append(_tr("Joint mode: both drivers work as one motor."))
    return notes


def _tr(text: str) -> str:
    return QCoreApplication.translate("drive_status", text)


_NOISE_COUNTS = 1
"""Counts that may be noise while nothing flows."""


class SafeStartWatch(QObject):
    """Remembers whether sticks were at rest, or motors drew current, since the board came.

    Inferred: the board has no flag for safe-start. It begins at power-up and when a required
    channel falls silent, and ends when the channels that drive are near neutral, all at once;
    how near is inferred, too. Ref: TReX Jr User's Guide 4.e.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._over = False

        device.telemetry.updated.connect(self._on_telemetry_updated)

    @property
    def may_hold(self) -> bool:
        """Whether a channel commands a speed, no current flows and nothing shows why."""
        values, currents = self._values(), self._device.telemetry.motor_currents
        return (
            bool(values) and currents is not None and not self._over and not self._device.is_joint
        )

    @Slot()
    def _on_telemetry_updated(self) -> None:
        values = self._values()
        if not values or self._has_lost_a_channel():
            self._over = False
        elif all(abs(value) <= NEARLY_NEUTRAL for value in values) or self._flows():
            self._over = True

    def _values(self) -> tuple[int, ...]:
        """What the channels that drive ask for; nothing where none does, or it is not known."""
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

    def _has_lost_a_channel(self) -> bool:
        state, telemetry = self._device.state, self._device.telemetry
        required = self._device.parameters.stored_of(ParameterKey.REQUIRED_CHANNELS) or 0
        return (
            state is not None
            and state.mode is Mode.RC
            and telemetry.raw is not None
            and any(telemetry.raw_of(channel) is None for channel in channels_in(required))
        )
