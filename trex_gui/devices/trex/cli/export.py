"""export: what a board is set to, as a program for a robot."""

from typing import Any

import click

from trex_gui.core.cli import ProgressLine, say
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_line
from trex_gui.devices.trex.cli.settings_io import FILE, save_file
from trex_gui.devices.trex.client.reading import read_everything
from trex_gui.devices.trex.settings.code_export import Language, export_code
from trex_gui.devices.trex.settings.document import settings_of


@click.command()
@link_options
@click.option(
    "--as",
    "language",
    type=click.Choice([language.value for language in Language]),
    required=True,
    help="What the program is written in.",
)
@click.argument("file", type=FILE)
def export(file: str, language: str, **options: Any) -> None:
    """Write a program to FILE that gives a board these settings; - is standard output.

    It checks what it stores, talks on a line set as this one is now, and has functions to
    drive the motors and to stop them.
    """
    link = link_settings(options)
    with open_line(link) as client:
        identify(client)
        with ProgressLine("Reading") as line:
            state = read_everything(client.request, line)
        text = export_code(settings_of(state), link, Language(language))
    save_file(file, text)
    if file != "-":
        say(f"{Language(language).title} for the {state.signature} saved to {file}.")
