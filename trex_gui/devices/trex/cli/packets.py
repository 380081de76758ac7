"""The raw and decode commands."""

from typing import Any

import click

from trex_gui.core.cli import CommandFailed, hexadecimal, say, seconds_option
from trex_gui.core.errors import BadRequest
from trex_gui.core.texts import counted, hex_text
from trex_gui.devices.trex.cli.common import (
    crc_option,
    link_options,
    link_settings,
    open_line,
    polynomial_option,
)
from trex_gui.devices.trex.cli.motor import run_motors
from trex_gui.devices.trex.protocol.descriptions import describe
from trex_gui.devices.trex.protocol.framing import Malformed, Packet, PacketParser
from trex_gui.devices.trex.protocol.raw_packets import RawPacket, packets_of, parse_hexadecimal
from trex_gui.devices.trex.session.messages import SendPacket


def _parse_bytes(words: tuple[str, ...]) -> bytes:
    try:
        return parse_hexadecimal(" ".join(words))
    except BadRequest as error:
        raise click.UsageError(str(error)) from error


@click.command()
@link_options
@click.option(
    "--motors",
    is_flag=True,
    help="Permit motor commands (C0 to F1). The motors run until Ctrl-C, or for the time given "
    "with --seconds. Then every motor is stopped.",
)
@seconds_option
@click.argument("packet", nargs=-1, required=True)
def raw(packet: tuple[str, ...], *, motors: bool, seconds: float | None, **options: Any) -> None:
    """Send the bytes of PACKET ("86 1F") unchanged and print each reply.

    Describes all packets before any packet is sent. The packets are sent one by one, because the
    board does not listen while it replies. Packets that may move a motor are rejected without
    --motors. With --motors, the final stop is repeated until the board confirms it, even after a
    signal or an error.
    """
    link = link_settings(options)
    packets = packets_of(_parse_bytes(packet), link.framing.polynomial)
    for item in packets:
        is_shared = link.device_number is not None and item.writes_everywhere
        board = "Every board on the line" if is_shared else "The board"
        say(f"{item.hexadecimal}: {item.description()}{_effect_text(item, board)}")
    may_move = any(item.moves for item in packets)
    if may_move and not motors:
        raise click.UsageError(
            "PACKET may move a motor, so nothing was sent. To send it, add --motors. Every motor "
            "is stopped afterwards."
        )
    if seconds is not None and not may_move:
        raise click.UsageError("--seconds needs a motor command in PACKET.")
    if may_move:
        numbered = enumerate(packets, 1)  # a server reports no outcome of a rejected request 0
        run_motors(link, [SendPacket(number, item) for number, item in numbered], seconds)
        return
    with open_line(link) as client:
        for item in packets:
            if received := client.send_packet(item.packet).raw:
                click.echo(hex_text(received))


def _effect_text(packet: RawPacket, board: str) -> str:
    if packet.moves:
        return ". This may move a motor"
    return f". {board} stores this at once, without a snapshot" if packet.writes else ""


@click.command()
@click.argument("packet", metavar="HEX", nargs=-1, required=True)
@crc_option
@polynomial_option
def decode(packet: tuple[str, ...], crc: bool, polynomial: str) -> None:
    """Describe HEX as packets from a host, in the compact or the expanded protocol.

    Values are in the units of a TReX. The exit code is 1 if any bytes are not part of a packet.
    """
    data = _parse_bytes(packet)
    try:
        parser = PacketParser(hexadecimal(polynomial) if crc else None)
    except BadRequest as error:
        raise click.UsageError(str(error)) from error
    events = parser.feed(data) + parser.flush()
    rows = [_row(event) for event in events]
    widths = [max(len(row[column]) for row in rows) for column in (0, 1)]
    for first, second, words in rows:
        click.echo(f"{first:{widths[0]}}  {second:{widths[1]}}  {words}")
    malformed = sum(isinstance(event, Malformed) for event in events)
    if malformed:
        parts = counted(len(events), "part")
        raise CommandFailed(f"Not a packet: {malformed} of {parts}.")


def _row(event: Packet | Malformed) -> tuple[str, str, str]:
    raw_text = hex_text(event.raw)
    if isinstance(event, Malformed):
        return raw_text, "bad", event.reason
    to = "compact" if event.device_number is None else f"to device {event.device_number}"
    return raw_text, to, describe(event.command)
