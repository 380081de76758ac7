"""get-settings, set-settings, check-settings, diff, export: a board's settings as a file."""

import sys
from collections.abc import Collection, Iterable
from dataclasses import asdict, replace
from functools import partial
from pathlib import Path
from typing import Any

import click

from trex_gui import __version__
from trex_gui.core.cli import (
    CommandFailed,
    Interruption,
    ProgressLine,
    json_option,
    print_json,
    refusals,
    say,
)
from trex_gui.core.code import Language
from trex_gui.core.file_name import FileName
from trex_gui.core.files import LARGEST_FILE, Finding, SettingsError, load, save
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.changes import (
    board_settings,
    read_board,
    remember_accepted,
    remember_notes,
    remembered,
    require_consent,
    require_serial_mode,
    say_changes,
    say_what_follows,
    warn,
    write_kept,
)
from trex_gui.devices.trex.cli.common import (
    identify,
    link_options,
    link_settings,
    open_line,
    open_line_to_change,
)
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_KEYS,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.errors import Skipped
from trex_gui.devices.trex.session.reconnecting import REACH
from trex_gui.devices.trex.settings.code_export import export_code
from trex_gui.devices.trex.settings.comparison import (
    Comparison,
    ComparisonRow,
    compare,
    settings_after,
)
from trex_gui.devices.trex.settings.conversion import conversion_lines
from trex_gui.devices.trex.settings.conversion import convert as convert_settings
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.repair import (
    accept_proposals,
    repair_text,
    repair_values,
)
from trex_gui.devices.trex.settings.rules import Context
from trex_gui.devices.trex.settings.writer import write_settings

FILE = FileName(allow_dash=True)  # checked by `load` and `save`, with better messages


def name_of(file: str) -> str:
    return "standard input" if file == "-" else file


def content_of(file: str) -> bytes:
    if file == "-":
        return sys.stdin.buffer.read(LARGEST_FILE + 1)
    return load(Path(file))


def read_file(file: str, *, fix: bool = False) -> Settings:
    """Return the settings of a file and report its warnings; `fix` repairs single values."""
    with refusals():
        data = content_of(file)
        text, repairs = repair_values(data, name_of(file)) if fix else (data, ())
        say_repairs(file, repairs)
        settings, findings = read_settings(text, name_of(file))
    for finding in findings:
        say(f"{name_of(file)}: {finding}")
    return settings


def converted(file: str, settings: Settings, product: Model, firmware: str | None) -> Settings:
    """Return settings for another model or firmware, and report what became of them."""
    conversion = convert_settings(settings, product, firmware)
    for line in conversion_lines(conversion):
        say(f"{name_of(file)}: {line}")
    return conversion.settings


def say_repairs(file: str, repairs: Iterable[str]) -> None:
    for line in repairs:
        say(f"{name_of(file)}: repaired: {line}")


def save_file(file: str, text: str) -> None:
    if file == "-":
        click.echo(text, nl=False)
        return
    with refusals():
        save(Path(file), text)


@click.command("get-settings")
@link_options
@click.argument("file", type=FILE)
def get_settings(file: str, **options: Any) -> None:
    """Save the board's settings to FILE; - is standard output.

    All parameters, the notes kept on this computer, and the calibrations of the active input
    source: the board does not show the others. An existing file is replaced.
    """
    with open_line(link_settings(options)) as client:
        state = read_board(client)
    settings = board_settings(state)
    text = write_settings(settings, title_lines=[f"Read from the board by trexcmd {__version__}"])
    for key, reason in state.unread.items():
        say(f"Warning: {key} could not be read and is left out: {reason}")
    save_file(file, text)
    if file != "-":
        parameters = counted(len(settings.parameters), "parameter")
        calibrations = counted(len(settings.calibrations), "calibration")
        say(f"{parameters} and {calibrations} of {state.signature} saved to {file}.")


def _read_numbers(text: str) -> tuple[int, ...]:
    numbers = []
    for part in text.split(","):
        if not (part.isascii() and part.isdigit() and int(part) < NUMBERS):
            raise click.BadParameter(f"a device number is 0 to {NUMBERS - 1}, not {part!r}")
        numbers.append(int(part))
    if len(set(numbers)) < len(numbers):
        raise click.BadParameter("each device number only once")
    return tuple(numbers)


@click.command("set-settings")
@link_options
@click.argument("file", type=FILE)
@click.option("--dry-run", is_flag=True, help="Show what would change, and write nothing.")
@click.option("--fix", is_flag=True, help="Repair the settings first, as check-settings does.")
@click.option(
    "--convert", is_flag=True, help="Take a file of the other model, or of newer firmware."
)
@click.option(
    "--devices",
    type=_read_numbers,
    metavar="N,N,...",
    help="Write to each of these boards on the line; each keeps its number and serial settings.",
)
@click.option(
    "--force", is_flag=True, help="Let the board decide about values beyond inferred limits."
)
def set_settings(
    file: str,
    *,
    dry_run: bool,
    fix: bool,
    convert: bool,
    force: bool,
    devices: tuple[int, ...] | None,
    **options: Any,
) -> None:
    """Write the settings of FILE to the board; - is standard input.

    Checks the file, saves a snapshot of what the board stores, writes only what differs, the
    serial settings last, and reads each value back. Ctrl-C ends it after the setting that is
    being written. Notes of the file are kept on this computer.

    With --convert, values that mean something else to this board are converted, what it does not
    have is left out, and both are listed.

    With --devices every board is read and checked before the first is written. The first error
    ends it: boards that come later are unchanged.
    """
    wanted = read_file(file, fix=fix)
    chosen = link_settings(options)
    command = f"trexcmd set-settings {name_of(file)}"
    kept = () if devices is None else REACH
    review = partial(
        _review, file, dry_run=dry_run, fix=fix, convert=convert, force=force, kept=kept
    )
    if devices is None:
        with open_line_to_change(chosen) as (client, rates):
            state, rows = review(wanted, client, rates)
            if rows:
                _write(client, chosen, state, command, rows)
        return
    others = {key: wire for key, wire in wanted.parameters.items() if key not in kept}
    wanted = replace(wanted, parameters=others)
    work = []
    for number in devices:
        say(f"Device {number}:")
        link = replace(chosen, device_number=number)
        with open_line_to_change(link) as (client, rates):
            work.append((link, *review(wanted, client, rates)))
    for link, state, rows in work:
        if rows:
            say(f"Device {link.device_number}:")
            with open_line(link) as client:
                _write(client, link, state, command, rows)


def _review(
    file: str,
    wanted: Settings,
    client: TrexClient,
    rates: frozenset[int] | None,
    *,
    dry_run: bool,
    fix: bool,
    convert: bool,
    force: bool,
    kept: Collection[str],
) -> tuple[DeviceState, list[ComparisonRow]]:
    """Report what the settings change of the board; return what it stores, and what to write."""
    identify(client)
    state = read_board(client)
    if convert:
        wanted = converted(file, wanted, state.signature.model, state.signature.firmware)
    wanted = _fitted(file, wanted, state)
    stored = board_settings(state)
    result = compare(stored, wanted)
    after = settings_after(stored, ((row.key, row.after) for row in result.rows))
    context = Context(port_rates=rates, used_by_line=client.settings.line)
    if fix:
        after, accepted = accept_proposals(after, context, kept=kept)
        say_repairs(file, map(repair_text, accepted))
        result = compare(stored, after)
    say(f"{result.summary()}.")
    warn(after, context)
    if dry_run:
        _print(result)
        return state, []
    if result.changed:
        require_consent(name_of(file), state, wanted.parameters, force=force)
        require_serial_mode(state, "These settings")
        say_changes(result)
    remember_notes(stored, wanted.notes)
    return state, [row for row in result.rows if row.changed]


@click.command()
@link_options
@click.argument("first", metavar="FILE", required=False, type=FILE)
@click.argument("second", metavar="[FILE]", required=False, type=FILE)
@click.option("--last", is_flag=True, help="Compare with what was applied last to the board.")
@json_option
def diff(first: str | None, second: str | None, last: bool, as_json: bool, **options: Any) -> None:
    """Show how the second FILE differs from the first, or FILE from the board.

    Prints nothing if they are equal; old values are left of new ones. With --last the board is
    compared with what this computer applied to it last, in the window or with trexcmd.
    """
    if first == second == "-":
        raise click.UsageError("Only one of the files can be standard input.")
    if last == (first is not None):
        raise click.UsageError("Give a FILE, or --last without one.")
    if first is None:
        with open_line(link_settings(options)) as client:
            identify(client)
            state = read_board(client)
        before = board_settings(state)
        record = remembered(before)
        if record.applied is None:
            raise CommandFailed("Nothing was applied to this board from this computer yet.")
        after = record.applied_to(before)
        names = ("the board", f"what was applied {record.applied.astimezone():%Y-%m-%d %H:%M}")
        say(f"Old: {names[0]}. New: {names[1]}.")
    elif second is not None:
        before, after = read_file(first), read_file(second)
        names = (name_of(first), name_of(second))
    else:
        wanted = read_file(first)
        with open_line(link_settings(options)) as client:
            identify(client)
            state = read_board(client)
        before, after = board_settings(state), _visible(wanted, state)
        names = ("the board", name_of(first))
    if before.product != after.product:
        say(
            f"Warning: these settings are for different models: {names[0]} "
            f"({before.product.name}) and {names[1]} ({after.product.name})."
        )
    result = compare(before, after)
    say(f"{result.summary()}.")
    if as_json:
        rows = [asdict(row) for row in result.differing]
        print_json({"differing": rows, "left_out": list(result.left_out)})
    else:
        _print(result)


# --- The board --------------------------------------------------------------------------


def _fitted(file: str, wanted: Settings, state: DeviceState) -> Settings:
    """Return the settings of a file that fit this board; SettingsError if none can."""
    board = state.signature
    if wanted.product != board.model:
        message = (
            f"these are settings of a {wanted.product.name}, the board is a {board}; --convert "
            "carries over what fits"
        )
        raise SettingsError(name_of(file), [Finding(1, "product", message)])
    known = {spec.key for spec in state.specs.readable}
    if strangers := [key for key in wanted.parameters if key not in known]:
        message = f"{board} does not have it; --convert leaves it out"
        raise SettingsError(name_of(file), [Finding(None, key, message) for key in strangers])
    if wanted.firmware not in {None, board.firmware}:
        say(f"Warning: these settings are for firmware {wanted.firmware}, the board is a {board}.")
    return replace(_visible(wanted, state), firmware=board.firmware)


def _visible(wanted: Settings, state: DeviceState) -> Settings:
    """Leave out the calibrations of the other input source, which the board does not show."""
    given = wanted.calibrations
    kept = {key: found for key, found in given.items() if key.source is state.source}
    if len(kept) < len(given):
        others = ", ".join(key for key in CalibrationKey if key in given.keys() - kept)
        say(
            f"Warning: {others} left out: only the calibrations for {state.source.value} inputs, "
            "the active ones, can be read and written."
        )
    return replace(wanted, calibrations=kept)


def _write(
    client: TrexClient,
    chosen: ConnectionSettings,
    state: DeviceState,
    command: str,
    rows: list[ComparisonRow],
) -> None:
    names = {row.key: row.name for row in rows}
    parameters = [(row.key, row.after) for row in rows if isinstance(row.after, int)]
    calibrations = [
        (CALIBRATION_KEYS[row.key], row.after) for row in rows if isinstance(row.after, Calibration)
    ]
    with ProgressLine("Writing") as line, Interruption() as interrupted:
        results = write_kept(
            client,
            state,
            command,
            parameters,
            calibrations,
            progress=line,
            cancelled=interrupted.__bool__,
        )
    failed = [result for result in results if result.error is not None]
    stored = {result.key: result.stored for result in results if result.error is None}
    _say_failures(failed, names)
    if failed and stored:
        say(f"Stored: {', '.join(names[key] for key in stored)}.")
    say(f"{len(stored)} of {counted(len(results), 'change')} stored and verified.")
    after = {key: wire for key, wire in stored.items() if isinstance(wire, int)}
    remember_accepted(state, after)
    say_what_follows(client, chosen, state, after)
    if failed:
        begun = "Interrupted: not" if interrupted else "Not"
        raise CommandFailed(f"{begun} all settings were stored; the others are unchanged.")


def _say_failures(failed: list[WriteResult], names: dict[str, str]) -> None:
    """Name failed writes; settings not tried after a fatal error are only listed."""
    said: set[int] = set()
    untried: list[str] = []
    for result in failed:
        name, text = names[result.key], str(result.error)
        if id(result.error) in said or isinstance(result.error, Skipped):
            untried.append(name)
            continue
        said.add(id(result.error))
        say(text if text.startswith(name) else f"{name}: {text}")
    if untried:
        after = " after that" if said else ""
        say(f"Not tried{after}: {', '.join(untried)}.")


def _print(result: Comparison) -> None:
    if text := result.report():
        click.echo(text)


@click.command()
@link_options
@click.option(
    "--as",
    "language",
    type=click.Choice([language.value for language in Language]),
    required=True,
    help="Language of the program.",
)
@click.argument("file", type=FILE)
def export(file: str, language: str, **options: Any) -> None:
    """Write a program to FILE that stores these settings in a board; - is standard output.

    The program verifies what it stores, uses the line settings of this connection, and has
    functions to drive and to stop the motors.
    """
    link = link_settings(options)
    with open_line(link) as client:
        identify(client)
        state = read_board(client)
        text = export_code(board_settings(state), link, Language(language))
    save_file(file, text)
    if file != "-":
        say(f"{Language(language).title} for the {state.signature} saved to {file}.")
