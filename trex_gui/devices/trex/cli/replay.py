"""replay: a saved transcript against the simulated board."""

from pathlib import Path

import click

from trex_gui.core.cli import CommandFailed, refusals, say
from trex_gui.core.command_io import FileName
from trex_gui.core.texts import counted, hex_text
from trex_gui.devices.trex.replay import RecordedTraffic


@click.command()
@click.argument("file", type=FileName(dir_okay=False))
@click.option("--all", "everything", is_flag=True, help="Print every difference, not the first.")
def replay(file: str, everything: bool) -> None:
    """Send the packets of a traffic log to a simulated board and compare the replies.

    FILE is what the traffic page saves and --traffic writes. The simulated board begins with the
    model, mode and stored values that the replies in FILE show; no port is opened and nothing real
    moves. Probes of a search are left out, and of measurements and error bits only the size is
    compared. The exit code is 1 if a reply differs.
    """
    with refusals():
        recorded = RecordedTraffic.load(Path(file))
    rows = recorded.rows
    say(f"Simulated board: {recorded.text()}.")
    differing = 0
    for row, received in recorded.replayed():
        differing += 1
        if differing == 1 or everything:
            click.echo(f"Line {row.line}: {hex_text(row.sent)}")
            for title, reply in (("file", row.received), ("simulator", received)):
                shown = hex_text(reply) or "nothing"
                click.echo(f"  {title + ':':11}{shown}  ({recorded.meaning(row, reply)})")
        if not everything:
            break
    for warning in recorded.warnings:
        say(f"Warning: {warning}")
    if differing:
        raise CommandFailed(
            f"Different replies: {differing}, in {counted(len(rows), 'transaction')}."
            if everything
            else "The simulator replies differently from here on; --all shows every difference."
        )
    click.echo(f"{counted(len(rows), 'transaction')}, no difference.")
