"""boards: which boards share a line."""

from typing import Any

import click

from trex_gui.core.cli import CommandFailed, Interruption, ProgressLine, json_option, print_json
from trex_gui.devices.trex.cli.common import link_options, link_settings, open_line, row_of
from trex_gui.devices.trex.discovery import NUMBERS, boards_by_number


@click.command()
@link_options
@json_option
def boards(as_json: bool, **options: Any) -> None:
    """List the boards that share the line, with the options that reach each.

    Asks for every device number which board has it, at the line settings of the options. No TReX
    moves a motor or changes anything. A board that is off, or has the number of another one, is not
    listed; `trexcmd find` also looks at other line settings.
    """
    link = link_settings(options)
    progress = ProgressLine("Asking")
    with open_line(link) as client, Interruption() as interrupted, progress as line:
        found = boards_by_number(
            client,
            lambda number: line(number, NUMBERS, f"for number {number}"),
            interrupted.__bool__,
        )
    if as_json:
        print_json([{"device_number": board.device_number, **row_of(board)} for board in found])
    else:
        for board in found:
            click.echo(f"{board.device_number}\t{board.signature}\t{row_of(board)['options']}")
    if not found:
        raise CommandFailed(f"No board replies to a device number on {link.text()}.")
