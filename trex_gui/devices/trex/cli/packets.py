"""raw, decode: packets in hexadecimal."""

import re
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, hexadecimal
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.cli.common import (
    crc_option,
    link_options,
    link_settings,
    open_line,
    polynomial_option,
)
from trex_gui.devices.trex.protocol.descriptions import describe
from trex_gui.devices.trex.protocol.framing import Malformed, Packet, PacketParser

_SILENCE = 0.25  # seconds without a byte after which `raw` takes a reply to be complete


def _bytes(words: tuple[str, ...]) -> bytes:
    """Read bytes such as `86 1F`, `861f` or `0x86, 0x1F`."""
    text = " ".join(words)
    try:
        data = bytes.fromhex(re.sub(r"0[xX]|[,;:]", " ", text))
    except ValueError as error:
        raise click.UsageError(f'"{text}" is not hexadecimal bytes such as "86 1F".') from error
    if not data:
        raise click.UsageError('Which bytes? Give them in hexadecimal, such as "86 1F".')
    return data


@click.command()
@link_options
@click.argument("packet", nargs=-1, required=True)
def raw(packet: tuple[str, ...], **options: Any) -> None:
    """Send the bytes of PACKET ("86 1F") unchanged and show the reply."""
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
    """Describe the packets in the bytes HEX, as a host sends them with either protocol.

    Units are those of a TReX. The exit code is 1 if some bytes are not a packet.
    """
    data = _bytes(packet)
    try:
        parser = PacketParser(hexadecimal(polynomial) if crc else None)
    except BadRequest as error:
        raise click.UsageError(str(error)) from error
    events = parser.feed(data) + parser.flush()
    rows = [_row(event) for event in events]
    widths = [max(len(row[column]) for row in rows) for column in (0, 1)]
    for first, second, words in rows:
        click.echo(f"{first:{widths[0]}}  {second:{widths[1]}}  {words}")
    bad = sum(isinstance(event, Malformed) for event in events)
    if bad:
        raise CommandFailed(f"{bad} of {len(events)} are not packets.")


def _row(event: Packet | Malformed) -> tuple[str, str, str]:
    raw_text = event.raw.hex(" ").upper()
    if isinstance(event, Malformed):
        return raw_text, "bad", event.reason
    to = "compact" if event.device_number is None else f"to device {event.device_number}"
    return raw_text, to, describe(event.command)
