"""Why the motors do what is asked of them, or do not: one reason, and what to do about it."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, auto
from math import ceil

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, Status, UartError, channels_in
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.ui.devices.connection_state import ConnectionState

_NO_ERROR = UartError(0)


class DriveBlocker(Enum):
    """What stands in the way; the first that holds is the one that is told."""

    NO_BOARD = auto()
    OPENING = auto()
    CLOSING = auto()
    SILENT = auto()
    UNKNOWN = auto()
    SAFE_START = auto()
    CHANNELS = auto()
    NOT_SERIAL = auto()
    LOCKED = auto()
    FAULT = auto()
    TIMEOUT = auto()
    LINE_ERROR = auto()
    NOT_ALLOWED = auto()
    NOT_ARMED = auto()
    OVER_LIMIT = auto()
    RUNNING = auto()


@dataclass(frozen=True, slots=True)
class DriveStatus:
    """What is so, and what a person can do about it; both are sentences."""

    kind: DriveBlocker
    text: str
    remedy: str = ""

    @property
    def obeyed(self) -> bool:
        """Whether the motors do what is asked, if more slowly."""
        return self.kind in {DriveBlocker.RUNNING, DriveBlocker.OVER_LIMIT}

    @property
    def alarming(self) -> bool:
        """Whether something is wrong, rather than not begun."""
        return self.kind in {
            *(
                DriveBlocker.SILENT,
                DriveBlocker.SAFE_START,
                DriveBlocker.FAULT,
                DriveBlocker.TIMEOUT,
            ),
            *(DriveBlocker.LINE_ERROR, DriveBlocker.OVER_LIMIT, DriveBlocker.LOCKED),
        }


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveInputs:
    """Everything that decides.

    Attributes:
        mode, by_serial: as the board says; `None` while that is not known.
        missing: channels that the board requires (RC mode) and gets no signal on.
        faults, over_limit: motors whose driver shut down, or whose current passed the limit, of
            late.
        perhaps_held: whether safe-start may hold the motors (`SafeStartWatch`).
        uart: UART errors of late.
        error_shutdown: whether the board is set to stop the motors at a UART error.
        timeout: the board's serial timeout, as text; empty when it is off or not known.
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
    can_arm: bool = True
    armed: bool = False
    stop_reason: str = ""


def reason_for(now: DriveInputs) -> DriveStatus:
    """Return the one reason that matters most."""
    for find in (_of_the_link, _of_the_mode, _of_the_lock, _of_the_board):
        if found := find(now):
            return found
    return _of_the_arming(now)


def situation_of(device: Device, *, perhaps_held: bool = False) -> DriveInputs:
    """Gather what decides from the models, and what was seen of safe-start."""
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
        can_arm=motors.can_arm,
        armed=motors.armed,
        stop_reason=motors.stop_reason,
    )


def _motors_with(bits: Sequence[Status | UartError], wanted: dict[int, Status]) -> tuple[int, ...]:
    seen = [bit for bit in bits if isinstance(bit, Status)]
    return tuple(motor for motor, bit in wanted.items() if bit in seen)


def _of_the_link(now: DriveInputs) -> DriveStatus | None:
    match now.link:
        case ConnectionState.DISCONNECTED:
            return DriveStatus(
                DriveBlocker.NO_BOARD, "No board is connected.", "Choose a port above."
            )
        case ConnectionState.CONNECTING:
            return DriveStatus(DriveBlocker.OPENING, "The board is being read.")
        case ConnectionState.DISCONNECTING:
            return DriveStatus(DriveBlocker.CLOSING, "The line is being closed.")
        case ConnectionState.NOT_RESPONDING:
            return DriveStatus(
                DriveBlocker.SILENT,
                "The board does not answer.",
                "Look at its power and the cable; a stop is sent again and again.",
            )
        case ConnectionState.CONNECTED:
            return None


def _of_the_mode(now: DriveInputs) -> DriveStatus | None:
    if now.mode is None or now.by_serial is None:
        return DriveStatus(
            DriveBlocker.UNKNOWN, "The board has not said yet who controls the motors."
        )
    if now.by_serial:
        return None
    if now.mode.is_serial:
        return DriveStatus(
            DriveBlocker.NOT_SERIAL,
            "The board says that serial commands do not control the motors.",
            "Switch it off and on.",
        )
    if now.missing:
        return DriveStatus(
            DriveBlocker.SAFE_START,
            f"Safe-start keeps the motors off: {_channels(now.missing)} required and "
            f"{'have' if len(now.missing) > 1 else 'has'} no signal.",
            "Switch the transmitter on and let go of its sticks.",
        )
    name = "RC" if now.mode is Mode.RC else "analog"
    text = f"The {name} channels control the motors, not this program"
    remedy = (
        "To drive from here, turn on the override switch (channel 5), or switch the board off, "
        "take the mode jumper off and switch it on."
    )
    if now.perhaps_held:
        return DriveStatus(
            DriveBlocker.CHANNELS,
            f"{text}; the motors are perhaps held by safe-start: let the sticks rest once.",
            remedy,
        )
    return DriveStatus(
        DriveBlocker.CHANNELS,
        f"{text}.",
        f"{remedy} After power-up safe-start waits for sticks at rest.",
    )


def _of_the_lock(now: DriveInputs) -> DriveStatus | None:
    if not now.locked_for or now.armed:
        return None
    return DriveStatus(
        DriveBlocker.LOCKED,
        f"Stopped. The motors are locked for {ceil(now.locked_for)} s.",
        "Then Run motor arms them again.",
    )


def _of_the_board(now: DriveInputs) -> DriveStatus | None:
    """What the board has latched of late; a limit only matters while something is driven."""
    if now.faults:
        return DriveStatus(
            DriveBlocker.FAULT,
            f"{_motors(now.faults)} without drive: the driver shut itself down (too hot, a short "
            "circuit, or low voltage).",
            "Ease the load, look at wires and battery, let it cool.",
        )
    if now.uart & UartError.TIMEOUT:
        after = f" for {now.timeout}" if now.timeout else ""
        return DriveStatus(
            DriveBlocker.TIMEOUT,
            f"Serial timeout: the board heard nothing{after} and stopped the motors.",
            "" if now.armed else "Run motor arms them again.",
        )
    if now.uart and now.error_shutdown:
        return DriveStatus(
            DriveBlocker.LINE_ERROR,
            "Serial errors: the board stops the motors when bytes arrive damaged.",
            "Look at cable and ground; UART-Error Shutdown can be turned off in Parameters.",
        )
    if now.over_limit and now.armed:
        verb = "are" if len(now.over_limit) > 1 else "is"
        return DriveStatus(
            DriveBlocker.OVER_LIMIT,
            f"{_motors(now.over_limit)} {verb} slowed down: the current passed its limit.",
            "Ease the load, or raise the current limit in Parameters.",
        )
    return None


def _of_the_arming(now: DriveInputs) -> DriveStatus:
    if now.armed:
        text = "The motors are armed: what you do here moves them."
        return DriveStatus(DriveBlocker.RUNNING, text + _notes(now), "Esc stops everything.")
    if not now.can_arm:
        return DriveStatus(DriveBlocker.NOT_ALLOWED, "The motors cannot be armed at this moment.")
    if now.stop_reason:
        return DriveStatus(
            DriveBlocker.NOT_ARMED,
            f"Stopped. {now.stop_reason}",
            "Run motor arms the motors again.",
        )
    return DriveStatus(
        DriveBlocker.NOT_ARMED,
        "Not armed: nothing is sent yet." + _notes(now),
        "Put the robot on blocks, then press Run motor.",
    )


def _notes(now: DriveInputs) -> str:
    """What is as it is, and good to know."""
    notes = ""
    if now.mode is not None and not now.mode.is_serial:
        notes += " Channel 5 overrides the sticks for as long as its switch is on."
    if now.joint:
        notes += " Joint mode: both drivers work as one motor."
    return notes


def _motors(motors: tuple[int, ...]) -> str:
    if len(motors) == 1:
        return f"Motor {motors[0]}"
    return "Motors " + " and ".join(str(motor) for motor in motors)


def _channels(channels: tuple[int, ...]) -> str:
    if len(channels) == 1:
        return f"channel {channels[0]} is"
    *first, last = (str(channel) for channel in channels)
    return f"channels {', '.join(first)} and {last} are"
