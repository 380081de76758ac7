"""The stream command."""

import contextlib
import csv
import itertools
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, TextIO

import click
from click.core import ParameterSource

from trex_gui.core.cli import CommandFailed, FiniteRange, Interruption, say, seconds_option
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_line
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import read_reliably
from trex_gui.devices.trex.client.telemetry import ModeSample, StatusReader, poll
from trex_gui.devices.trex.protocol.commands import GetMode
from trex_gui.devices.trex.recording import MeasurementTable, Row
from trex_gui.devices.trex.session.polling import Schedule, rates

_FLUSH = 0.25  # maximum seconds until other programs can read a row
_SLICE = 0.02  # maximum seconds between two checks for signals
_MAX_FAILURES = 10  # consecutive failures after which the board counts as gone


def _read_separator(_context: click.Context, _option: click.Parameter, text: str) -> str:
    """Parse a separator. Quotes, line ends, letters and characters in numbers are invalid."""
    character = {"tab": "\t", r"\t": "\t"}.get(text.lower(), text)
    if len(character) != 1 or character.isalnum() or character in '"\r\n.-+_':
        raise click.BadParameter(f'{text!r} is neither a character such as ";" nor the word "tab".')
    return character


@click.command()
@link_options
@click.option(
    "--csv",
    "file",
    type=FileName(dir_okay=False, allow_dash=True),
    metavar="FILE|-",
    help='CSV file to write. "-" is standard output, the default.',
)
@seconds_option
@click.option(
    "--interval",
    type=FiniteRange(0),
    default=0.0,
    metavar="S",
    help="Minimum time between two rows in seconds. By default, every row is written.",
)
@click.option("--limit", type=click.IntRange(1), metavar="N", help="End after N rows.")
@click.option(
    "--separator",
    default=",",
    callback=_read_separator,
    metavar="CHAR",
    help='Character between two columns, or "tab". Default: a comma.',
)
@click.option("--json", "as_json", is_flag=True, help="Write one JSON object per line, not CSV.")
@click.pass_context
def stream(
    context: click.Context,
    /,
    *,
    file: str | None,
    seconds: float | None,
    interval: float,
    limit: int | None,
    separator: str,
    as_json: bool,
    **options: Any,
) -> None:
    """Write the board's measurements as CSV, with a row for each new pair of motor currents.

    The header contains the units. The other columns of a row contain the newest values. Error bits
    are only in the first row after they were read, because reading clears them in the board.
    --interval leaves out rows, but not their error bits. The measured currents may be off by 20 %
    (twin), as documented for a board with the same motor drivers.
    """
    if as_json and file is not None:
        raise click.UsageError(
            "--json and --csv cannot be combined. --json writes to standard output."
        )
    if as_json and context.get_parameter_source("separator") is not ParameterSource.DEFAULT:
        raise click.UsageError("--separator has no effect with --json.")
    settings = link_settings(options)
    with open_line(settings) as client, Interruption() as interrupted:
        unit = identify(client).model.current_unit
        mode = read_reliably(client.request, GetMode(), has_crc=client.has_crc)
        table = MeasurementTable(mode, unit)
        with _target(file) as target:  # opened last, so a missing board changes no file
            out = csv.DictWriter(target, list(table.row), lineterminator="\n", delimiter=separator)
            if not as_json:
                out.writeheader()
            count, flushed_at, reason = 0, 0.0, ""
            try:
                polled = _rows(client, table, seconds, interrupted, interval)
                for row in itertools.islice(polled, limit):
                    if as_json:
                        target.write(json.dumps(row) + "\n")
                    else:
                        out.writerow(row)
                    count += 1
                    if (now := client.transport.clock()) - flushed_at >= _FLUSH:
                        flushed_at = now
                        target.flush()
            except (NoReply, BadReply) as error:
                reason = f"The board has stopped responding: {error}"
            except _ModeChanged:
                reason = "The board's mode has changed, and with it the meaning of its inputs."
            finally:
                target.flush()
                if count:
                    say(f"{counted(count, 'row')}.")
            if reason:
                raise CommandFailed(reason)


class _ModeChanged(Exception):  # noqa: N818 - an event
    pass


@contextlib.contextmanager
def _target(file: str | None) -> Iterator[TextIO]:
    if file is None or file == "-":
        yield sys.stdout
        return
    try:
        with Path(file).open("w", encoding="utf-8", newline="") as opened:
            yield opened
    except OSError as error:
        raise CommandFailed(f"{file} cannot be written: {error.strerror or error}.") from error


def _rows(
    client: TrexClient,
    table: MeasurementTable,
    seconds: float | None,
    interrupted: Interruption,
    interval: float,
) -> Iterator[Row]:
    """Poll the board. Yield complete rows, at most one every `interval` seconds."""
    clock = client.transport.clock
    reader = StatusReader(clock)
    schedule = Schedule()
    started = clock()
    schedule.start(rates(table.mode.source), started)
    failures, due = 0, started
    while not interrupted and (seconds is None or clock() - started < seconds):
        now = clock()
        topic = schedule.next(now)
        if topic is None:
            client.transport.wait(min(_SLICE, schedule.seconds_to_next(now) or 0.0))
            continue
        schedule.record_poll(topic, now)
        try:
            sample = poll(client.request, topic, clock, reader)
            if (
                isinstance(sample, ModeSample)
                and sample.mode is not table.mode
                and client.request(GetMode()) is sample.mode  # a single reply may be corrupted
            ):
                raise _ModeChanged
            failures = 0
        except (NoReply, BadReply):
            failures += 1
            if failures == _MAX_FAILURES:
                raise
            continue
        if sample and table.add(sample) and sample.time >= due:
            due = sample.time + interval
            yield table.finish(sample.time - started)
