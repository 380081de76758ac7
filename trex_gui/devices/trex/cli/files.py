"""Commands that use settings files without changing a board."""

import sys
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, json_option, print_json, reported_errors, say
from trex_gui.core.code import Language
from trex_gui.core.command_io import FAILURE_EXIT_CODE, FileName
from trex_gui.core.files import LARGEST_FILE, load, save
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.changes import board_settings, read_board, record_of
from trex_gui.devices.trex.cli.common import link_options, link_settings, open_line, specs_of
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, CalibrationKey
from trex_gui.devices.trex.settings.code_export import export_code
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings, settings_of
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.version import __version__

FILE = FileName(allow_dash=True)  # `load` and `save` check files, with better messages


def name_of(file: str) -> str:
    return "standard input" if file == "-" else file


def content_of(file: str) -> bytes:
    if file == "-":
        return sys.stdin.buffer.read(LARGEST_FILE + 1)
    return load(Path(file))


def read_file(file: str) -> Settings:
    with reported_errors():
        settings, findings = read_settings(content_of(file), name_of(file))
    for finding in findings:
        say(f"{name_of(file)}: {finding}")
    return settings


def save_file(file: str, text: str) -> None:
    if file == "-":
        click.echo(text, nl=False)
        return
    with reported_errors():
        save(Path(file), text)


def visible(target: Settings, state: DeviceState) -> Settings:
    """Remove the calibrations of the inactive input source, because the board hides them."""
    calibrations = target.calibrations
    active = {key: value for key, value in calibrations.items() if key.source is state.source}
    if len(active) < len(calibrations):
        others = ", ".join(key for key in CalibrationKey if key in calibrations.keys() - active)
        say(
            f"Warning: {others} left out, because the board now uses its {state.source.value} "
            "inputs and hides all other calibrations."
        )
    return replace(target, calibrations=active)


def print_comparison(result: Comparison) -> None:
    if text := result.report():
        click.echo(text)


class ComparisonCommand(click.Command):
    """Command that compares settings. Its callback returns True if all settings are equal.

    The exit codes are those of diff(1): 0 equal, 1 different, 2 failure.
    """

    def invoke(self, ctx: click.Context) -> Any:
        ctx.meta[FAILURE_EXIT_CODE] = 2
        ctx.exit(0 if super().invoke(ctx) else 1)


def _print_differences(
    before: Settings, after: Settings, names: tuple[str, str], *, as_json: bool
) -> bool:
    """Print the differences between settings. Return True if there are none."""
    if before.product != after.product:
        say(
            f"Warning: these settings are for different models: {names[0]} "
            f"({before.product.name}) and {names[1]} ({after.product.name})."
        )
    result = compare(before, after)
    is_equal = before.product == after.product and not (result.differing or result.left_out)
    say(f"{result.summary()}.")
    if as_json:
        rows = [asdict(row) for row in result.differing]
        print_json({"equal": is_equal, "differing": rows, "left_out": list(result.left_out)})
    else:
        print_comparison(result)
    return is_equal


@click.command("get-settings")
@link_options
@click.argument("file", type=FILE)
def get_settings(file: str, **options: Any) -> None:
    """Save the board's settings to FILE. "-" is standard output.

    FILE contains all parameters, the notes saved on this computer, and the calibrations of the
    active input source. The board hides the calibrations of the other source. An existing file is
    replaced.
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


@click.command(cls=ComparisonCommand)
@link_options
@click.argument("first", metavar="FILE", required=False, type=FILE)
@click.argument("second", metavar="[FILE]", required=False, type=FILE)
@click.option("--last", is_flag=True, help="Compare with the settings last applied to the board.")
@json_option
def diff(first: str | None, second: str | None, last: bool, as_json: bool, **options: Any) -> bool:
    """Show how FILE differs from the board, or from another FILE.

    With two files, shows how the second differs from the first. Old values are to the left of new
    values. Prints nothing if the settings are equal. With --last, the board is compared with the
    settings that this computer last applied, in the window or with trexcmd. Exit codes: 0 equal,
    1 different, 2 wrong usage or unreadable.
    """
    if first == second == "-":
        raise click.UsageError("Only one of the files can be standard input.")
    if last == (first is not None):
        raise click.UsageError("Give either a FILE or --last.")
    if first is None:
        with open_line(link_settings(options)) as client:
            state = read_board(client)
        before = board_settings(state)
        record = record_of(before)
        if record.applied is None:
            raise CommandFailed("No settings have been applied to this board from this computer.")
        after = record.applied_to(before)
        applied = f"{record.applied.astimezone():%Y-%m-%d %H:%M}"
        names = ("the board", f"the settings applied on {applied}")
        say(f"Old: {names[0]}. New: {names[1]}.")
    elif second is not None:
        before, after = read_file(first), read_file(second)
        names = (name_of(first), name_of(second))
    else:
        target = read_file(first)
        with open_line(link_settings(options)) as client:
            state = read_board(client)
        before, after = board_settings(state), visible(target, state)
        names = ("the board", name_of(first))
    return _print_differences(before, after, names, as_json=as_json)


@click.command(cls=ComparisonCommand)
@link_options
@click.argument("profile", type=FILE)
@click.option("--ignore", "ignored", multiple=True, metavar="KEY", help="Do not check KEY.")
@json_option
def audit(profile: str, ignored: tuple[str, ...], as_json: bool, **options: Any) -> bool:
    """Check that the board stores the settings of PROFILE. "-" is standard input.

    Notes are not checked, nor are settings that PROFILE does not contain. Prints the differences,
    with the board's values on the left. Exit codes: 0 equal, 1 different, 2 wrong usage or
    unreadable.
    """
    left_out = {name if name in CALIBRATION_KEYS else specs_of(name)[0].key for name in ignored}
    target = read_file(profile)
    with open_line(link_settings(options)) as client:
        state = read_board(client)
    target = visible(target, state)
    keys = target.keys - left_out
    for key in keys & state.unread.keys():
        raise CommandFailed(f"{key} could not be read: {state.unread[key]}")
    stored, target = (replace(s.only(keys), notes={}) for s in (settings_of(state), target))
    return _print_differences(stored, target, ("the board", name_of(profile)), as_json=as_json)


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
    """Export the board's settings to FILE as a program. "-" is standard output.

    The program stores the settings in a board and verifies each value. It uses the line settings of
    this connection, and has functions that drive and stop the motors.
    """
    link = link_settings(options)
    with open_line(link) as client:
        state = read_board(client)
        text = export_code(board_settings(state), link, Language(language))
    save_file(file, text)
    if file != "-":
        say(f"{Language(language).title} for the {state.signature} saved to {file}.")
