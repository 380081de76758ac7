"""calibration get, calibration set."""

import re
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
    open_line_to_change,
    rounded,
)
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    HIGHEST_CODED,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.rules import Context

_UNITS = {
    "us": (InputSource.RC, 1.0),
    "µs": (InputSource.RC, 1.0),
    "μs": (InputSource.RC, 1.0),
    "ms": (InputSource.RC, 1000.0),
    "v": (InputSource.ANALOG, 1.0),
    "mv": (InputSource.ANALOG, 0.001),
}
_VALUE = re.compile(r"(\d+(?:\.\d+)?)\s*([a-zµμ]*)", re.IGNORECASE)


@click.group()
def calibration() -> None:
    """Show or store channel calibrations, for the active input source."""


@calibration.command("get")
@link_options
@json_option
def get_command(as_json: bool, **options: Any) -> None:
    """Show the calibration of each channel, in counts and in physical units.

    With --json, the fields of a channel are counts; pulse_us or voltage_V has them in that unit.
    """
    with open_line(link_settings(options)) as client:
        state = read_board(client)
    source, rows, learned = state.source, state.calibrations, channels_in(state.calibrated)
    if as_json:
        report = {
            "source": source.value,
            "channels": [
                {
                    "channel": channel,
                    "differs_from_default": channel in learned,
                    **asdict(row),
                    PHYSICAL_KEYS[source]: {
                        name: rounded(source, count) for name, count in asdict(row).items()
                    },
                }
                for channel, row in rows.items()
            ],
        }
        print_json(report)
        return
    for channel, row in rows.items():
        click.echo(_text(channel, row, source) + ("" if channel in learned else "  (default)"))


@calibration.command("set")
@link_options
@click.argument("channel", type=click.IntRange(CHANNELS[0], CHANNELS[-1]))
@click.argument("minimum")
@click.argument("neutral")
@click.argument("maximum")
@click.argument("deadband")
def set_command(channel: int, **options: Any) -> None:
    """Store the calibration of a channel and read it back.

    Values are counts (3750), or have a unit: 1500us for RC pulses, 2.5V for voltages. Saves a
    snapshot of what the board stores first. Writes nothing if the board has this calibration.
    """
    given = {name: _parse(name, options.pop(name)) for name in CALIBRATION_FIELDS}
    link = link_settings(options)
    meant = {_UNITS[unit][0] for _, unit in given.values() if unit}
    if len(meant) > 1:
        raise click.UsageError("A calibration is in µs or in V, not in both.")
    try:  # before a snapshot is saved
        wanted = Calibration(**{name: _counts(*value) for name, value in given.items()})
        wanted.encode()
    except BadRequest as error:
        raise click.UsageError(f"{error}.") from error
    with open_line_to_change(link) as (client, rates):
        state = read_board(client)
        source = state.source
        if meant - {source}:
            raise BadRequest(
                f"The board measures its inputs as {source.value} now, so values are in "
                f"{source.unit}."
            )
        key = CalibrationKey.of(source, channel)
        stored = settings_of(state)
        change_one(
            client,
            state,
            replace(stored, calibrations={**stored.calibrations, key: wanted}),
            Context(port_rates=rates, used_by_line=link.line),
            what=f"Calibration of channel {channel}",
            command=f"trexcmd calibration set {channel}",
        )
        click.echo(_text(channel, wanted, source))


def _parse(name: str, text: str) -> tuple[float, str]:
    found = _VALUE.fullmatch(text.strip())
    unit = found[2].lower() if found else ""
    if found is None or (unit and unit not in _UNITS) or (not unit and "." in found[1]):
        raise click.UsageError(
            f"{name.upper()} is counts (3750), or like 1500us or 2.5V, not {text!r}."
        )
    return float(found[1]), unit


def _counts(number: float, unit: str) -> int:
    if unit:
        source, factor = _UNITS[unit]
        number = source.counts(number * factor)
    return int(min(number, HIGHEST_CODED + 1))


def _text(channel: int, row: Calibration, source: InputSource) -> str:
    counts = " ".join(map(str, astuple(row)))
    physical = " / ".join(map(source.text, astuple(row)))
    return f"{channel}\t{counts}\t{physical}"
