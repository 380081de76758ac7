"""The command status."""

import json
from typing import Any

import click

from trex_gui.core.cli import json_option
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_line
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.explanations import MODE_TEXT, who_controls
from trex_gui.devices.trex.client.reading import DeviceState, query, read_everything
from trex_gui.devices.trex.client.telemetry import LatchedStatus, StatusReader
from trex_gui.devices.trex.protocol.commands import GetCurrents, GetRawChannels, GetRemappedChannels
from trex_gui.devices.trex.protocol.flags import (
    CHANNELS,
    STATUS_MEANING,
    UART_MEANING,
    Status,
    UartError,
)
from trex_gui.devices.trex.protocol.parameters import ParameterKey


@click.command()
@link_options
@json_option
def status(as_json: bool, **options: Any) -> None:
    """Show what the board is, how it is set and what it measures.

    Reading the error bits clears them in the board.
    """
    with open_line(link_settings(options)) as client:
        identify(client)
        state = read_everything(client.request)
        news = StatusReader(client.transport.clock).read(client.request)
        report = _report(client, state, news)
    if as_json:
        click.echo(json.dumps(report, indent=2))
        return
    for key, value in report.items():
        if isinstance(value, str):
            click.echo(f"{key.replace('_', ' ').capitalize() + ':':22}{value}")
    click.echo("Channels:")
    for row in report["channels"]:
        physical = row["physical"] if row["raw"] is not None else "no signal"
        counts = "" if row["raw"] is None else f" ({row['raw']})"
        click.echo(f"  {row['channel']}  {physical}{counts}, remapped {row['remapped']}")
    click.echo("Errors: " + (", ".join(report["errors"]) or "none"))
    click.echo("Parameters:")
    for key, row in report["parameters"].items():
        click.echo(f"  {key:28}{row['value']:>4}  {row['text']}")


def names_of(news: LatchedStatus | None) -> list[str]:
    """Return the names of the latched bits."""
    status_bits = news.status if news else Status(0)
    uart_bits = news.uart if news else UartError(0)
    names = [name for bit, (name, _) in STATUS_MEANING.items() if bit & status_bits]
    return names + [name for bit, (name, _) in UART_MEANING.items() if bit & uart_bits]


def _report(client: TrexClient, state: DeviceState, news: LatchedStatus | None) -> dict[str, Any]:
    raw = query(client.request, GetRawChannels())
    remapped = query(client.request, GetRemappedChannels())
    currents = query(client.request, GetCurrents())
    unit = state.signature.model.current_unit
    return {
        "product": state.signature.model.name,
        "firmware": state.signature.firmware,
        "mode": MODE_TEXT[state.mode],
        "in_control": who_controls(
            state.mode,
            state.serial_controls,
            joint=state.parameters.get(ParameterKey.MOTOR_MODE) == 1,
        ),
        "serial_controls": state.serial_controls,
        "motor_1_current": f"{currents[0] * unit:.2f} A",
        "motor_2_current": f"{currents[1] * unit:.2f} A",
        "channels": [
            {
                "channel": channel,
                "raw": count,
                "physical": None if count is None else state.source.text(count),
                "remapped": remapped[channel],
            }
            for channel in CHANNELS
            for count in (raw[channel],)
        ],
        "errors": names_of(news),
        "parameters": {
            key: {"value": wire, "text": state.specs[key].text(wire)}
            for key, wire in state.parameters.items()
        },
    }
