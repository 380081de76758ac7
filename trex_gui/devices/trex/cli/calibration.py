"""The calibration get and calibration set commands."""

from dataclasses import asdict, astuple, replace
from typing import Any

import click

from trex_gui.core.cli import json_option, print_json
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.cli.changes import change_one, read_board
from trex_gui.devices.trex.cli.common import (
    PHYSICAL_KEYS,
    link_options,
    link_settings,
    open_line,
    open_line_for_writing,
    physical_value,
)
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    Calibration,
    CalibrationKey,
    read_count,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.rules import Context


@click.group()
def calibration() -> None:
    """Show or store the channel calibrations of the active input source."""


@calibration.command("get")
@link_options
@json_option
def get_command(as_json: bool, **options: Any) -> None:
    """Show the calibration of each channel, in counts and in physical units.

    With --json, the fields of a channel are counts. `pulse_us` or `voltage_V` contains the same
    fields in physical units.
    """
    with open_line(link_settings(options)) as client:
        state = read_board(client)
    source, rows, changed = state.source, state.calibrations, channels_in(state.calibrated)
    if as_json:
        report = {
            "source": source.value,
            "channels": [
                {
                    "channel": channel,
                    "differs_from_default": channel in changed,
                    **asdict(row),
                    PHYSICAL_KEYS[source]: {
                        name: physical_value(source, count) for name, count in asdict(row).items()
                    },
                }
                for channel, row in rows.items()
            ],
        }
        print_json(report)
        return
    for channel, row in rows.items():
        click.echo(_text(channel, row, source) + ("" if channel in changed else "  (default)"))


@calibration.command("set")
@link_options
@click.argument("channel", type=click.IntRange(CHANNELS[0], CHANNELS[-1]))
@click.argument("minimum")
@click.argument("neutral")
@click.argument("maximum")
@click.argument("deadband")
def set_command(channel: int, **options: Any) -> None:
    """Store the calibration of a channel and read it back.

    Values are counts (3750) or have a unit: 1500us for RC pulses, 2.5V for voltages. A snapshot of
    the stored settings is saved first. Nothing is written if the board already has this
    calibration.
    """
    given = {name: _parse(name, options.pop(name)) for name in CALIBRATION_FIELDS}
    link = link_settings(options)
    sources = {source for _, source in given.values() if source}
    if len(sources) > 1:
        raise click.UsageError("A calibration cannot contain both µs and V.")
    try:
        target = Calibration(**{name: count for name, (count, _) in given.items()})
        target.encode()
    except BadRequest as error:
        raise click.UsageError(f"{error}.") from error
    with open_line_for_writing(link) as (client, rates):
        state = read_board(client)
        source = state.source
        if sources - {source}:
            raise BadRequest(
                f"The board currently measures {source.value} inputs, so values must be in "
                f"{source.unit}."
            )
        key = CalibrationKey.of(source, channel)
        stored = settings_of(state)
        change_one(
            client,
            state,
            replace(stored, calibrations={**stored.calibrations, key: target}),
            Context(port_rates=rates, active_line=link.line),
            name=f"Calibration of channel {channel}",
            command=f"trexcmd calibration set {channel}",
        )
        click.echo(_text(channel, target, source))


def _parse(name: str, text: str) -> tuple[int, InputSource | None]:
    try:
        return read_count(text)
    except BadRequest as error:
        raise click.UsageError(f"{name.upper()}: {error}.") from error


def _text(channel: int, row: Calibration, source: InputSource) -> str:
    counts = " ".join(map(str, astuple(row)))
    physical = " / ".join(map(source.text, astuple(row)))
    return f"{channel}\t{counts}\t{physical}"
