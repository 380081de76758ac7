"""Descriptions of the commands, replies and states of a TReX."""

from typing import Any

from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.protocol import commands as c
from trex_gui.devices.trex.protocol.calibration import Calibration
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
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, channels_text, parameters_of

CURRENT_ACCURACY = tr_noop("Measured currents may be off by 20 % (twin).")

_FIELD_TEXTS = {
    "minimum": tr_noop("minimum"),
    "neutral": tr_noop("neutral"),
    "maximum": tr_noop("maximum"),
    "deadband": tr_noop("deadband"),
}

_FIXED_TEXTS: dict[type[c.Command[Any]], str] = {
    c.GetSignature: tr_noop("get signature"),
    c.GetMode: tr_noop("get mode"),
    c.GetSerialControl: tr_noop("get serial control flag"),
    c.GetStatus: tr_noop("get and clear status bits"),
    c.GetUartErrors: tr_noop("get and clear UART error bits"),
    c.GetCurrents: tr_noop("get currents of both motors"),
    c.GetCalibratedChannels: tr_noop("get channels with a changed calibration"),
    c.Null: tr_noop("null command (no effect)"),
}

_MODE_NAMES = {
    Mode.RC: tr_noop("RC mode"),
    Mode.ANALOG: tr_noop("analog mode"),
    Mode.SERIAL_RC: tr_noop("serial mode, RC inputs"),
    Mode.SERIAL_ANALOG: tr_noop("serial mode, analog inputs"),
}

_RESULTS = {
    ResultCode.OK: tr_noop("stored"),
    ResultCode.BAD_PARAMETER: tr_noop("rejected: no such parameter (code 1)"),
    ResultCode.BAD_VALUE: tr_noop("rejected: this value is not allowed (code 2)"),
    ResultCode.NOT_SERIAL_MODE: tr_noop("rejected: not in serial mode (code 3)"),
}

MODE_TEXT = {
    Mode.RC: tr_noop("RC mode: a radio receiver drives the motors."),
    Mode.ANALOG: tr_noop("Analog mode: voltages (joysticks, potentiometers) drive the motors."),
    Mode.SERIAL_RC: tr_noop("Serial mode, with inputs read as RC pulses."),
    Mode.SERIAL_ANALOG: tr_noop("Serial mode, with inputs read as voltages."),
}

CHANNEL_ROLES = {  # in RC and analog mode; in serial mode, the channels are only measured
    1: tr_noop("motor 1 (mixed: turn)"),
    2: tr_noop("motor 2 (mixed: forward)"),
    3: tr_noop("auxiliary motor"),
    4: tr_noop("flip switch"),
    5: tr_noop("serial override switch"),
}

STOP_UNCONFIRMED = tr_noop("The stop is not confirmed. If a motor is still turning, cut its power.")
STOP_WITHOUT_EFFECT = tr_noop(
    "The stop was sent, but has no effect yet: the channels control the motors until channel "
    "5 gives control to serial commands. Release the sticks, or cut the power."
)


def describe(command: c.Command[Any], board: c.Signature | None = None) -> str:
    """Describe a command in units of `board`, by default a TReX with the newest firmware."""
    if (text := _FIXED_TEXTS.get(type(command))) is not None:
        return tr(text)
    match command:
        case c.GetRawChannels():
            return tr("get raw inputs of {0}").format(_channels(command.channels))
        case c.GetRemappedChannels():
            return tr("get remapped inputs of {0}").format(_channels(command.channels))
        case c.GetCurrent(motor=motor):
            return tr("get current of motor {0}").format(motor)
        case c.GetCalibration(channel=channel):
            return tr("get calibration of channel {0}").format(channel)
        case c.SetCalibration(channel=channel, calibration=calibration):
            text = tr("set calibration of channel {0}: {1}")
            return text.format(channel, _calibration(calibration))
        case c.GetParameter(number=number):
            return tr("get {0}").format(_parameter(number, board))
        case c.SetParameter(number=number, value=value):
            name, physical = _parameter(number, board), _value(number, value, board)
            return tr("set {0} to {1}").format(name, physical)
        case c.DriveMotor(motor=motor, drive=drive, accelerate=accelerate):
            return tr("{0} motor {1} to {2}").format(_verb(accelerate), motor, _drive(drive))
        case c.DriveBoth(motor1=first, motor2=second, accelerate=accelerate):
            text = tr("{0} motor 1 to {1}, motor 2 to {2}")
            return text.format(_verb(accelerate), _drive(first), _drive(second))
        case c.DriveAuxiliary(speed=speed, accelerate=accelerate):
            return tr("{0} auxiliary motor to {1}").format(_verb(accelerate), speed)
    return type(command).__name__


def describe_reply(command: c.Command[Any], value: Any, board: c.Signature | None = None) -> str:
    """Describe a parsed reply. The text is empty for a command without a reply."""
    match command, value:
        case _, c.Signature():
            return str(value)
        case _, Mode():
            return tr(_MODE_NAMES[value])
        case _, ResultCode():
            return tr(_RESULTS[value])
        case _, (Status() | UartError()):
            return ", ".join(map(tr, bit_names(value))) or tr("none")
        case _, Calibration():
            return _calibration(value)
        case c.GetSerialControl(), _:
            return tr("yes") if value else tr("no")
        case ((c.GetRawChannels() | c.GetRemappedChannels()), _):
            no_signal = tr("no signal")
            return ", ".join(
                f"{channel}: {no_signal if count is None else count}"
                for channel, count in value.items()
            )
        case c.GetCurrent(motor=motor), _:
            return _current(motor, value, board)
        case c.GetCurrents(), _:
            return ", ".join(_current(motor, count, board) for motor, count in enumerate(value, 1))
        case c.GetCalibratedChannels(), _:
            return _channels(channels_in(value))
        case c.GetParameter(number=number), _:
            return _value(number, value, board)
    return "" if value is None else str(value)


def describe_control(mode: Mode, by_serial: bool, *, joint: bool) -> str:
    """Describe the source of motor control: serial commands or channels."""
    if mode.is_serial and by_serial:
        text = tr("Serial commands control the motors (serial mode).")
    elif by_serial:
        text = tr("Serial commands control the motors: channel 5 overrides the other inputs.")
    else:
        text = tr(
            "The {0} channels control the motors. Serial commands take effect only when "
            "channel 5 gives control to them. For serial mode, switch the board off, remove "
            "the mode jumper and switch the board on again."
        ).format("RC" if mode is Mode.RC else tr("analog"))
    if joint:
        text += tr(
            " Joint mode: both drivers work together as motor 1, and commands for "
            "motor 2 are ignored."
        )
    return text


def is_refusal(value: object) -> bool:
    return isinstance(value, ResultCode) and value is not ResultCode.OK


def _current(motor: int, count: int, board: c.Signature | None) -> str:
    if board is None:
        return tr("motor {0}: {1} counts").format(motor, count)
    return tr("motor {0}: {1:.2f} A").format(motor, Number(count * board.model.current_unit))


def _calibration(calibration: Calibration) -> str:
    texts = _FIELD_TEXTS.items()
    return ", ".join(f"{tr(text)} {getattr(calibration, name)}" for name, text in texts)


def _channels(channels: tuple[int, ...]) -> str:
    if channels in {(), CHANNELS}:
        return tr("all channels") if channels else tr("no channel")
    return channels_text(channels)


def _verb(accelerate: bool) -> str:
    return tr("accelerate") if accelerate else tr("set")


def _drive(drive: Drive) -> str:
    if drive.is_brake:
        return tr("brake with {0}").format(drive.speed) if drive.speed else tr("coast")
    return f"{tr(drive.direction.name.lower())} {drive.speed}"


def _spec(number: int, board: c.Signature | None) -> ParameterSpec | None:
    if board is not None:
        return parameters_of(board.model.key, board.firmware).number(number)
    model = device_table().models[0]
    return parameters_of(model.key, model.firmware[-1]).number(number)


def _parameter(number: int, board: c.Signature | None) -> str:
    spec = _spec(number, board)
    if spec is not None:
        return spec.name
    source = tr("no TReX") if board is None else tr("no {0}").format(board)
    return tr("parameter {0:#04x}, which {1} has").format(number, source)


def _value(number: int, value: int, board: c.Signature | None) -> str:
    spec = _spec(number, board)
    if spec is None or not spec.readable:
        return f"{value:#04x}"
    text = spec.text(value)
    return text if text == str(value) else f"{text} ({value})"
