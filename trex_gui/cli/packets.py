"""raw, decode: bytes as they are, and what they mean."""

import re
from typing import Any

import click

from trex_gui.cli.common import (
    crc_option,
    hexadecimal,
    link_options,
    link_settings,
    open_line,
    polynomial_option,
)
from trex_gui.cli.talk import Refused, Usage
from trex_gui.protocol.commands import (
    Command,
    Drive,
    DriveAuxiliary,
    DriveBoth,
    DriveMotor,
    GetCalibratedChannels,
    GetCalibration,
    GetCurrent,
    GetCurrents,
    GetMode,
    GetParameter,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetSignature,
    GetStatus,
    GetUartErrors,
    Null,
    SetCalibration,
    SetParameter,
)
from trex_gui.protocol.device_table import device_table
from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.parameters import parameters_of
from trex_gui.protocol.parser import Malformed, Packet, PacketParser

_SILENCE = 0.25
"""Seconds without a byte after which `raw` takes an answer to be whole."""

_CALIBRATION_FIELDS = ("minimum", "neutral", "maximum", "deadband")

_QUERIES: dict[type[Command[Any]], str] = {
    GetSignature: "get signature",
    GetMode: "get mode",
    GetSerialControl: "get whether serial controls the motors",
    GetStatus: "get status bits, and clear them",
    GetUartErrors: "get UART error bits, and clear them",
    GetCurrents: "get currents of both motors",
    GetCalibratedChannels: "get which calibrations differ from the default",
    Null: "null command: nothing",
}


def _bytes(words: tuple[str, ...]) -> bytes:
    """Read bytes as people write them: `86 1F`, `861f`, `0x86, 0x1F`.

    Raises:
        Usage: they are none.
    """
    text = " ".join(words)
    try:
        data = bytes.fromhex(re.sub(r"0[xX]|[,;:]", " ", text))
    except ValueError as error:
        raise Usage(f'"{text}" is not hexadecimal bytes such as "86 1F".') from error
    if not data:
        raise Usage('Which bytes? Give them in hexadecimal, such as "86 1F".')
    return data


@click.command()
@link_options
@click.argument("packet", nargs=-1, required=True)
def raw(packet: tuple[str, ...], **options: Any) -> None:
    """Send the bytes of PACKET ("86 1F") as they are, and show what comes back."""
    data = _bytes(packet)
    with open_line(link_settings(options)) as client:
        transport = client.transport
        transport.discard()
        transport.write(data)
        seconds = client.settings.line.seconds(len(data)) + _SILENCE
        received = bytearray()
        while chunk := transport.read(1, seconds):
            received += chunk
            seconds = _SILENCE
    click.echo(received.hex(" ").upper())


@click.command()
@click.argument("packet", metavar="HEX", nargs=-1, required=True)
@crc_option
@polynomial_option
def decode(packet: tuple[str, ...], crc: bool, polynomial: str) -> None:
    """Say what packets the bytes HEX are, as a host sends them, in both protocols.

    Units are those of a TReX. Exits with 1 when something is no packet.
    """
    data = _bytes(packet)
    try:
        parser = PacketParser(hexadecimal(polynomial) if crc else None)
    except BadRequest as error:
        raise Usage(str(error)) from error
    events = parser.feed(data) + parser.flush()
    rows = [_row(event) for event in events]
    widths = [max(len(row[column]) for row in rows) for column in (0, 1)]
    for first, second, words in rows:
        click.echo(f"{first:{widths[0]}}  {second:{widths[1]}}  {words}")
    bad = sum(isinstance(event, Malformed) for event in events)
    if bad:
        raise Refused(f"{bad} of {len(events)} are no packets.")


def _row(event: Packet | Malformed) -> tuple[str, str, str]:
    raw_text = event.raw.hex(" ").upper()
    if isinstance(event, Malformed):
        return raw_text, "bad", event.reason
    to = "compact" if event.device_number is None else f"to device {event.device_number}"
    return raw_text, to, describe(event.command)


def describe(command: Command[Any]) -> str:
    """Say a command in words."""
    if (text := _QUERIES.get(type(command))) is not None:
        return text
    match command:
        case GetRawChannels():
            return f"get raw inputs of {_channels(command.channels)}"
        case GetRemappedChannels():
            return f"get remapped inputs of {_channels(command.channels)}"
        case GetCurrent(motor=motor):
            return f"get current of motor {motor}"
        case GetCalibration(channel=channel):
            return f"get calibration of channel {channel}"
        case SetCalibration(channel=channel, calibration=calibration):
            values = ", ".join(
                f"{name} {getattr(calibration, name)}" for name in _CALIBRATION_FIELDS
            )
            return f"set calibration of channel {channel}: {values}"
        case GetParameter(number=number):
            return f"get {_parameter(number)}"
        case SetParameter(number=number, value=value):
            return f"set {_parameter(number)} to {_value(number, value)}"
        case DriveMotor(motor=motor, drive=drive, accelerate=accelerate):
            return f"{_verb(accelerate)} motor {motor} to {_drive(drive)}"
        case DriveBoth(motor1=first, motor2=second, accelerate=accelerate):
            verb = _verb(accelerate)
            return f"{verb} motor 1 to {_drive(first)}, motor 2 to {_drive(second)}"
        case DriveAuxiliary(speed=speed, accelerate=accelerate):
            return f"{_verb(accelerate)} auxiliary motor to {speed}"
    return type(command).__name__


def _channels(channels: tuple[int, ...]) -> str:
    if not channels:
        return "no channel"
    word = "channel" if len(channels) == 1 else "channels"
    return f"{word} {', '.join(map(str, channels))}"


def _verb(accelerate: bool) -> str:
    return "accelerate" if accelerate else "set"


def _drive(drive: Drive) -> str:
    if drive.is_brake:
        return f"brake with {drive.speed}" if drive.speed else "coast"
    return f"{drive.direction.name.lower()} {drive.speed}"


def _parameter(number: int) -> str:
    model = device_table().models[0]
    spec = parameters_of(model.key, model.firmware[-1]).number(number)
    return f"parameter {number:#04x}, which no TReX has" if spec is None else spec.name


def _value(number: int, value: int) -> str:
    model = device_table().models[0]
    spec = parameters_of(model.key, model.firmware[-1]).number(number)
    if spec is None or not spec.readable:
        return f"{value:#04x}"
    text = spec.text(value)
    return text if text == str(value) else f"{text} ({value})"
