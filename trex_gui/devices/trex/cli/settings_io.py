"""Settings files of the command line: - stands for standard input or output."""

import sys
from pathlib import Path

import click

from trex_gui.core.cli import refusals, say
from trex_gui.core.files import LARGEST_FILE, load, save
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings

FILE = click.Path(allow_dash=True)
"""What is wrong with a file `load` and `save` say better."""


def name_of(file: str) -> str:
    """Return the name of the file for messages."""
    return "standard input" if file == "-" else file


def content_of(file: str) -> bytes:
    """Return what a file holds.

    Raises:
        SettingsError: it cannot be read.
    """
    if file == "-":
        return sys.stdin.buffer.read(LARGEST_FILE + 1)
    return load(Path(file))


def read_file(file: str) -> Settings:
    """Return the settings of a file; warnings are said.

    Raises:
        Refused: they cannot be used.
    """
    with refusals():
        settings, findings = read_settings(content_of(file), name_of(file))
    for finding in findings:
        say(f"{name_of(file)}: {finding}")
    return settings


def save_file(file: str, text: str) -> None:
    """Write a settings file, whole or not at all.

    Raises:
        Refused: it cannot be written.
    """
    if file == "-":
        click.echo(text, nl=False)
        return
    with refusals():
        save(Path(file), text)
