"""Commands, replies and states of a TReX in words."""

from collections.abc import Mapping
from typing import Any

from trex_gui.devices.trex.protocol import commands as c
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_FIELDS, Calibration
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import (
    CHANNELS,
    Mode,
    Status,
    UartError,
    bit_names,
    channels_in,
)
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of

_QUERIES: dict[type[c.Command[Any]], str] = {
    c.GetSignature: "get signature",
    c.GetMode: "get mode",
    c.GetSerialControl: "get whether serial controls the motors",
    c.GetStatus: "get status bits, and clear them",
    c.GetUartErrors: "get UART error bits, and clear them",
    c.GetCurrents: "get currents of both motors",
    c.GetCalibratedChannels: "get which calibrations differ from the default",
    c.Null: "null command: nothing",
}

_MODES = {
    Mode.RC: "RC mode",
    Mode.ANALOG: "analog mode",
    Mode.SERIAL_RC: "serial mode, RC inputs",
    Mode.SERIAL_ANALOG: "serial mode, analog inputs",
}

_RESULTS = {
    ResultCode.OK: "stored",
    ResultCode.BAD_PARAMETER: "rejected: no such parameter (code 1)",
    ResultCode.BAD_VALUE: "rejected: this value is not allowed (code 2)",
    ResultCode.NOT_SERIAL_MODE: "rejected: not in serial mode (code 3)",
}

MODE_TEXT = {
    Mode.RC: "RC mode: a radio receiver drives the motors.",
    Mode.ANALOG: "Analog mode: voltages (joysticks, potentiometers) drive the motors.",
    Mode.SERIAL_RC: "Serial mode, with inputs read as RC pulses.",
    Mode.SERIAL_ANALOG: "Serial mode, with inputs read as voltages.",
}

CHANNEL_ROLES = {
    1: "motor 1 (mixed: turn)",
    2: "motor 2 (mixed: forward)",
    3: "auxiliary motor",
    4: "flip switch",
    5: "serial override switch",
}
"""The function of each channel in RC and analog mode; in serial mode they are only measured."""

BEYOND_A_STOP = (
    "The stop was sent, but the channels control the motors: it takes effect only when channel 5 "
    "gives control to serial commands. Release the sticks, or cut the power."
)
"""A stop is a serial command; it does not stop motors that channels control."""


def describe(command: c.Command[Any], board: c.Signature | None = None) -> str:
    """Say a command in words; units are those of `board`, else of the newest TReX."""
    if (text := _QUERIES.get(type(command))) is not None:
        return text
    match command:
        case c.GetRawChannels():
            return f"get raw inputs of {_channels(command.channels)}"
        case c.GetRemappedChannels():
            return f"get remapped inputs of {_channels(command.channels)}"
        case c.GetCurrent(motor=motor):
            return f"get current of motor {motor}"
        case c.GetCalibration(channel=channel):
            return f"get calibration of channel {channel}"
        case c.SetCalibration(channel=channel, calibration=calibration):
            return f"set calibration of channel {channel}: {_calibration(calibration)}"
        case c.GetParameter(number=number):
            return f"get {_parameter(number, board)}"
        case c.SetParameter(number=number, value=value):
            return f"set {_parameter(number, board)} to {_value(number, value, board)}"
        case c.DriveMotor(motor=motor, drive=drive, accelerate=accelerate):
            return f"{_verb(accelerate)} motor {motor} to {_drive(drive)}"
        case c.DriveBoth(motor1=first, motor2=second, accelerate=accelerate):
            verb = _verb(accelerate)
            return f"{verb} motor 1 to {_drive(first)}, motor 2 to {_drive(second)}"
        case c.DriveAuxiliary(speed=speed, accelerate=accelerate):
            return f"{_verb(accelerate)} auxiliary motor to {speed}"
    return type(command).__name__


def describe_reply(command: c.Command[Any], value: Any, board: c.Signature | None = None) -> str:
    """Say the result of a command's `parse` in words; empty for a command without a reply."""
    match command, value:
        case _, c.Signature():
            return str(value)
        case _, Mode():
            return _MODES[value]
        case _, ResultCode():
            return _RESULTS[value]
        case _, (Status() | UartError()):
            return ", ".join(bit_names(value)) or "none"
        case _, Calibration():
            return _calibration(value)
        case c.GetSerialControl(), _:
            return "yes" if value else "no"
        case ((c.GetRawChannels() | c.GetRemappedChannels()), _):
            return _by_channel(value)
        case c.GetCurrent(motor=motor), _:
            return _current(motor, value, board)
        case c.GetCurrents(), _:
            return ", ".join(_current(motor, count, board) for motor, count in enumerate(value, 1))
        case c.GetCalibratedChannels(), _:
            return _channels(channels_in(value))
        case c.GetParameter(number=number), _:
            return _value(number, value, board)
    return "" if value is None else str(value)


def who_controls(mode: Mode, by_serial: bool, *, joint: bool) -> str:
    """Return who controls the motors, and how to give control to this program."""
    note = (
        " Joint mode: both drivers work together as motor 1, motor 2 is ignored." if joint else ""
    )
    if mode.is_serial and by_serial:
        return "Serial commands control the motors (serial mode)." + note
    if by_serial:
        return "Serial commands control the motors: channel 5 overrides the other inputs." + note
    channels = "RC" if mode is Mode.RC else "analog"
    return (
        f"The {channels} channels control the motors. Serial commands take effect only when "
        "channel 5 gives control to them; for serial mode, switch the board off, remove the mode "
        "jumper and switch it on." + note
    )


def is_refusal(value: object) -> bool:
    return isinstance(value, ResultCode) and value is not ResultCode.OK


def _by_channel(values: Mapping[int, int | None]) -> str:
    said = (
        f"{channel}: {'no signal' if value is None else value}" for channel, value in values.items()
    )
    return ", ".join(said)


def _current(motor: int, count: int, board: c.Signature | None) -> str:
    if board is None:
        return f"motor {motor}: {count} counts"
    return f"motor {motor}: {count * board.model.current_unit:.2f} A"


def _calibration(calibration: Calibration) -> str:
    return ", ".join(f"{name} {getattr(calibration, name)}" for name in CALIBRATION_FIELDS)


def _channels(channels: tuple[int, ...]) -> str:
    if channels in {(), CHANNELS}:
        return "all channels" if channels else "no channel"
    word = "channel" if len(channels) == 1 else "channels"
    return f"{word} {', '.join(map(str, channels))}"


def _verb(accelerate: bool) -> str:
    return "accelerate" if accelerate else "set"


def _drive(drive: Drive) -> str:
    if drive.is_brake:
        return f"brake with {drive.speed}" if drive.speed else "coast"
    return f"{drive.direction.name.lower()} {drive.speed}"


def _spec(number: int, board: c.Signature | None) -> ParameterSpec | None:
    if board is not None:
        return parameters_of(board.model.key, board.firmware).number(number)
    model = device_table().models[0]
    return parameters_of(model.key, model.firmware[-1]).number(number)


def _parameter(number: int, board: c.Signature | None) -> str:
    spec = _spec(number, board)
    source = "no TReX" if board is None else f"no {board}"
    return f"parameter {number:#04x}, which {source} has" if spec is None else spec.name


def _value(number: int, value: int, board: c.Signature | None) -> str:
    spec = _spec(number, board)
    if spec is None or not spec.readable:
        return f"{value:#04x}"
    text = spec.text(value)
    return text if text == str(value) else f"{text} ({value})"
