"""The history command and its subcommands."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem

from trex_gui.core.cli import CommandFailed, json_option, print_json, reported_errors, say
from trex_gui.core.files import load
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.common import link_options
from trex_gui.devices.trex.cli.files import FILE, ComparisonCommand, read_file
from trex_gui.devices.trex.cli.files import diff as diff_settings
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot


def _complete_number(_ctx: click.Context, _param: click.Parameter, incomplete: str) -> list[Any]:
    return [
        CompletionItem(word, help=" ".join(filter(None, _cells(number, snapshot)[1:])))
        for number, snapshot in enumerate(SettingsHistory().snapshots(), 1)
        for word in filter(None, (str(number), snapshot.name))
        if word.startswith(incomplete)
    ]


_HELP = """List the snapshots of settings, newest first.

A snapshot is saved before any settings are written, in the window or by `set`, `set-settings`,
`calibration set` and `restore-defaults`. To restore snapshot 3:

\b
trexcmd history diff 3
trexcmd set-settings "$(trexcmd history path 3)"

Number 1 is the newest snapshot. Each new snapshot increases the numbers of the older snapshots
by one. A snapshot with a name can also be selected by its name, and is never removed automatically.
"""


@click.group(invoke_without_command=True, help=_HELP)
@click.option("--find", "words", metavar="TEXT", help="List only snapshots with these words.")
@json_option
@click.pass_context
def history(ctx: click.Context, words: str | None, as_json: bool) -> None:
    if ctx.invoked_subcommand is None:
        _list(words or "", as_json=as_json)
    elif as_json:
        raise click.UsageError(f"Write --json after {ctx.invoked_subcommand}.")
    elif words is not None:
        raise click.UsageError(f"{ctx.invoked_subcommand} has no --find option.")


def _list(words: str, *, as_json: bool) -> None:
    history = SettingsHistory()
    terms = words.casefold().split()
    matches = [
        (number, snapshot)
        for number, snapshot in enumerate(history.snapshots(), 1)
        if all(word in " ".join(_cells(number, snapshot)).casefold() for word in terms)
    ]
    if problem := history.limit().problem:
        say(f"Warning: {problem}")
    if as_json:
        print_json([_json_row(number, snapshot) for number, snapshot in matches])
        return
    if not matches and terms:
        say("No snapshot contains these words.")
        return
    if not matches:
        say(
            "There are no snapshots yet. Each Apply and each command that changes settings first "
            f"saves a snapshot in {history.folder}."
        )
        return
    titles = ("", "Time", "Board", "No.", "Adapter", "Before", "Name", "Note")
    cells = [titles, *(_cells(number, snapshot) for number, snapshot in matches)]
    while not any(row[-1] for row in cells[1:]):  # drop empty columns at the right
        cells = [row[:-1] for row in cells]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    for first, *rest in cells:
        texts = (text.ljust(width) for text, width in zip(rest, widths[1:], strict=True))
        click.echo("  ".join((first.rjust(widths[0]), *texts)).rstrip())


@history.command("show")
@click.argument("selector", metavar="N|FILE", type=FILE, shell_complete=_complete_number)
@json_option
def show(selector: str, as_json: bool) -> None:
    """Print the settings of a snapshot, given by its number in the list or by its file."""
    path = _path_of(selector)
    settings = read_file(str(path))
    if not as_json:
        with reported_errors():
            click.echo(load(path).decode("utf-8-sig"), nl=False)
        return
    report = {
        "path": str(path),
        "product": settings.product.name,
        "firmware": settings.firmware,
        "parameters": dict(settings.parameters),
        "calibrations": {key: asdict(value) for key, value in settings.calibration_items()},
    }
    print_json(report)


@history.command("diff", cls=ComparisonCommand)
@click.argument("first", metavar="N|FILE", type=FILE, shell_complete=_complete_number)
@click.argument(
    "second", metavar="[N|FILE]", required=False, type=FILE, shell_complete=_complete_number
)
@link_options
@json_option
@click.pass_context
def diff(ctx: click.Context, /, first: str, second: str | None, **options: Any) -> bool:
    """Show how a snapshot differs from the board, or from another snapshot.

    With two snapshots, shows how the second differs from the first. With one, the board's values
    are on the left, and the values that the snapshot would restore are on the right. Prints nothing
    if the settings are equal. The exit codes are those of `trexcmd diff`.
    """
    other = None if second is None else str(_path_of(second))
    return bool(ctx.invoke(diff_settings, first=str(_path_of(first)), second=other, **options))


@history.command("name")
@click.argument("selector", metavar="N|NAME", shell_complete=_complete_number)
@click.argument("name", required=False)
@click.option(
    "--note", metavar="TEXT", help="Note on the snapshot. An empty text removes the note."
)
def name(selector: str, name: str | None, note: str | None) -> None:
    """Give a snapshot a name, a note or both.

    A snapshot with a name is kept, regardless of the limit, until its name is removed with "".
    """
    given = {"name": name, "note": note}
    texts = {kind: text for kind, text in given.items() if text is not None}
    if not texts:
        raise click.UsageError("Give a name, or a note with --note.")
    with reported_errors():
        SettingsHistory().label(_snapshot_of(selector), **texts)


@history.command("path")
@click.argument("selector", metavar="N|NAME", shell_complete=_complete_number)
def path(selector: str) -> None:
    """Print the path of a snapshot's file."""
    click.echo(_snapshot_of(selector).path)


@history.command("keep")
@click.argument("count", metavar="COUNT|all", required=False)
@click.option("--yes", is_flag=True, help="Do not ask for confirmation.")
def limit_command(count: str | None, yes: bool) -> None:
    """Set or print the number of snapshots to keep.

    The number applies to trexcmd and the window. Asks for confirmation before older snapshots are
    removed.
    """
    history = SettingsHistory()
    if count is None:
        limit = history.limit()
        if limit.problem:
            raise CommandFailed(limit.problem)
        click.echo("all" if limit.count is None else limit.count)
        return
    new_limit = _parse_count(count)
    if (excess := len(history.excess(new_limit))) and not yes:
        total = counted(len(history.snapshots()), "snapshot")
        which = "the oldest" if excess == 1 else f"the oldest {excess}"
        click.confirm(f"Remove {which} of {total} permanently?", abort=True, err=True)
    with reported_errors():
        removed = len(history.set_limit(new_limit))
    if removed:
        say(f"{counted(removed, 'snapshot')} removed.")
    say("All snapshots are kept." if new_limit is None else f"The newest {new_limit} are kept.")


def _parse_count(word: str) -> int | None:
    if word.casefold() == "all":
        return None
    if not word.isascii() or not word.isdecimal() or not 1 <= int(word[:8]) < 10**7:
        raise click.UsageError(f'Give a number of snapshots (at least 1) or "all", not {word!r}.')
    return int(word)


def _path_of(word: str) -> Path:
    """Return the file of a snapshot given by number or name. Any other word is a path."""
    is_number = word.isdecimal() and len(word) <= 9
    if not is_number and all(snapshot.name != word for snapshot in SettingsHistory().snapshots()):
        return Path(word)
    return _snapshot_of(word).path


def _snapshot_of(word: str) -> Snapshot:
    history = SettingsHistory()
    snapshots = history.snapshots()
    named = next((snapshot for snapshot in snapshots if snapshot.name == word), None)
    if named is not None and not word.isdecimal():
        return named
    if not word.isdecimal() or len(word) > 9:
        raise click.UsageError(
            f"{word!r} is neither the number nor the name of a snapshot. Number 1 is the newest."
        )
    if 1 <= int(word) <= len(snapshots):
        return snapshots[int(word) - 1]
    if not snapshots:
        raise click.UsageError(f"There are no snapshots in {history.folder} yet.")
    raise click.UsageError(
        f"There is no snapshot {word}; snapshots are numbered 1 to {len(snapshots)}."
    )


def _cells(number: int, snapshot: Snapshot) -> tuple[str, ...]:
    device = snapshot.device_number
    return (
        str(number),
        snapshot.taken.astimezone().strftime("%Y-%m-%d %H:%M:%S"),
        f"{snapshot.product} {snapshot.firmware}".strip() if not snapshot.problem else "damaged",
        "" if device is None else str(device),
        snapshot.adapter,
        snapshot.problem or snapshot.reason,
        snapshot.name,
        snapshot.note,
    )


def _json_row(number: int, snapshot: Snapshot) -> dict[str, Any]:
    return {
        "number": number,
        "taken": snapshot.taken.isoformat(),
        "product": snapshot.product or None,
        "firmware": snapshot.firmware or None,
        "device_number": snapshot.device_number,
        "adapter": snapshot.adapter,
        "reason": snapshot.reason,
        "name": snapshot.name or None,
        "note": snapshot.note or None,
        "problem": snapshot.problem or None,
        "path": str(snapshot.path),
    }
