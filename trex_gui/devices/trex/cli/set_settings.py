"""The set-settings command."""

from dataclasses import replace
from functools import partial
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, Interruption, ProgressLine, say, shell_words
from trex_gui.core.files import Finding, SettingsError
from trex_gui.core.texts import counted
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.cli.changes import (
    board_settings,
    keeper_of,
    read_board,
    require_consent,
    require_serial_mode,
    save_notes,
    say_changes,
    say_next_steps,
    warn,
)
from trex_gui.devices.trex.cli.common import (
    link_options,
    link_settings,
    open_line,
    open_line_for_writing,
)
from trex_gui.devices.trex.cli.files import FILE, name_of, print_comparison, read_file, visible
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Skipped
from trex_gui.devices.trex.session.reconnecting import LINK_KEYS
from trex_gui.devices.trex.settings.comparison import (
    ComparisonRow,
    compare,
    settings_after,
    values_to_write,
)
from trex_gui.devices.trex.settings.conversion import conversion_lines
from trex_gui.devices.trex.settings.conversion import convert as convert_settings
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.rules import Context


def _read_numbers(text: str) -> tuple[int, ...]:
    numbers = []
    for part in text.split(","):
        if not (part.isascii() and part.isdigit() and int(part) < NUMBERS):
            raise click.BadParameter(f"a device number must be 0 to {NUMBERS - 1}, not {part!r}")
        numbers.append(int(part))
    if len(set(numbers)) < len(numbers):
        raise click.BadParameter("give each device number only once")
    return tuple(numbers)


@click.command("set-settings")
@link_options
@click.argument("file", type=FILE)
@click.option("--dry-run", is_flag=True, help="Show the changes, but write nothing.")
@click.option(
    "--convert", is_flag=True, help="Accept a file for another model or for newer firmware."
)
@click.option(
    "--devices",
    type=_read_numbers,
    metavar="N,N,...",
    help="Write to each of these boards on the line. Each board keeps its device number and "
    "serial settings.",
)
@click.option(
    "--force",
    is_flag=True,
    help="Let the board decide whether to accept values beyond inferred limits.",
)
def set_settings(
    file: str,
    *,
    dry_run: bool,
    convert: bool,
    force: bool,
    devices: tuple[int, ...] | None,
    **options: Any,
) -> None:
    """Write the settings of FILE to the board. "-" is standard input.

    Checks the file, saves a snapshot of the stored settings, writes only the differences, and reads
    each value back. Serial settings are written last. Ctrl-C ends the command after the current
    setting. Notes in the file are saved on this computer.

    With --dry-run, as in a real run, the exit code is 0 even if settings differ. `trexcmd audit
    FILE` exits with 1 if the board has different settings.

    With --convert, values that have a different meaning on this board are converted, and settings
    that the board does not have are left out. Both are listed.

    With --devices, every board is read and checked before anything is written. The first error ends
    the command, and later boards in the list do not change.
    """
    target = read_file(file)
    base = link_settings(options)
    command = shell_words("trexcmd", "set-settings", file)
    review = partial(_review, file, dry_run=dry_run, convert=convert, force=force)
    if devices is None:
        with open_line_for_writing(base) as (client, rates):
            state, rows = review(target, client, rates)
            if rows:
                _write(client, base, state, command, rows)
        return
    target = target.without(LINK_KEYS)
    work = []
    for number in devices:
        say(f"Device {number}:")
        link = replace(base, device_number=number)
        with open_line_for_writing(link) as (client, rates):
            work.append((link, *review(target, client, rates)))
    for link, state, rows in work:
        if rows:
            say(f"Device {link.device_number}:")
            with open_line(link) as client:
                _write(client, link, state, command, rows)


def _review(
    file: str,
    target: Settings,
    client: TrexClient,
    rates: frozenset[int] | None,
    *,
    dry_run: bool,
    convert: bool,
    force: bool,
) -> tuple[DeviceState, list[ComparisonRow]]:
    """Report the changes. Return the state of the board, and the rows to write."""
    state = read_board(client)
    if convert:
        conversion = convert_settings(target, state.signature.model, state.signature.firmware)
        for line in conversion_lines(conversion):
            say(f"{name_of(file)}: {line}")
        target = conversion.settings
    target = _fitted(file, target, state)
    stored = board_settings(state)
    result = compare(stored, target)
    after = settings_after(stored, ((row.key, row.after) for row in result.rows))
    say(f"{result.summary()}.")
    warn(after, Context(port_rates=rates, active_line=client.settings.line))
    if dry_run:
        print_comparison(result)
        return state, []
    if result.changed:
        require_consent(name_of(file), state, target.parameters, force=force)
        require_serial_mode(state, "These settings")
        say_changes(result)
    save_notes(client, state, target.notes)
    return state, [row for row in result.rows if row.changed]


def _fitted(file: str, target: Settings, state: DeviceState) -> Settings:
    """Return a file's settings for this board. Raises SettingsError if they do not fit."""
    board = state.signature
    if target.product != board.model:
        message = (
            f"these are settings of a {target.product.name}, but the board is a {board}; "
            "--convert carries over the settings that fit"
        )
        raise SettingsError(name_of(file), [Finding(1, "product", message)])
    known = state.specs.readable_by_key
    if unknown := [key for key in target.parameters if key not in known]:
        message = f"a {board} does not have this setting; --convert leaves it out"
        raise SettingsError(name_of(file), [Finding(None, key, message) for key in unknown])
    if target.firmware not in {None, board.firmware}:
        say(f"Warning: these settings are for firmware {target.firmware}. The board is a {board}.")
    return replace(visible(target, state), firmware=board.firmware)


def _write(
    client: TrexClient,
    link: ConnectionSettings,
    state: DeviceState,
    command: str,
    rows: list[ComparisonRow],
) -> None:
    names = {row.key: row.name for row in rows}
    with ProgressLine("Writing") as line, Interruption() as interrupted:
        results = keeper_of(client, state).write(
            client,
            state,
            command,
            *values_to_write(rows),
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
    say_next_steps(client, link, state, after)
    if failed:
        prefix = "Interrupted: not" if interrupted else "Not"
        raise CommandFailed(f"{prefix} all settings were stored; the rest is unchanged.")


def _say_failures(failed: list[WriteResult], names: dict[str, str]) -> None:
    """Report failed writes, and list the settings that were not tried after a fatal error."""
    reported: set[int] = set()
    untried: list[str] = []
    for result in failed:
        name, text = names[result.key], str(result.error)
        if id(result.error) in reported or isinstance(result.error, Skipped):
            untried.append(name)
            continue
        reported.add(id(result.error))
        say(text if text.startswith(name) else f"{name}: {text}")
    if untried:
        after = " after that" if reported else ""
        say(f"Not tried{after}: {', '.join(untried)}.")
