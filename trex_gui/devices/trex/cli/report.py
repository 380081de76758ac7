"""The report command."""

import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from trex_gui.core.cli import reported_errors, say
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import StudioError
from trex_gui.core.host import host
from trex_gui.core.report import create_report, save_report
from trex_gui.core.texts import counted
from trex_gui.core.transport.traffic import logged
from trex_gui.core.transport.transcript import TranscriptWriter
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_port
from trex_gui.devices.trex.cli.status import board_report
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import read_everything
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.writer import write_settings


@click.command()
@link_options
@click.argument("file", metavar="FILE.zip|-", type=FileName(dir_okay=False, allow_dash=True))
def report(file: str, **options: Any) -> None:
    """Save a report for support: versions, ports, status, settings and traffic in a zip file.

    With "-", the report is printed instead. Names of users and computers, network addresses, and
    serial numbers of adapters are masked. If no board replies, the report says why. Reading the
    error bits clears them in the board.
    """
    with reported_errors():
        files = create_report(_parts(options))
        if file == "-":
            for part in files:
                click.echo(f"==> {part.name} <==\n{part.text}")
            return
        save_report(Path(file), files)
    for part in files:
        say(f"{part.name}: {counted(len(part.data), 'byte')}")
    click.echo(file)


def _parts(options: dict[str, Any]) -> dict[str, Callable[[], str]]:
    """Read the board and return the report's files. `status.txt` may contain a read error."""
    if not options["port"]:
        return {}
    settings, clock = link_settings(options), host().clock
    writer = TranscriptWriter(None, TrexDecoder(), time.time() - clock())
    try:
        client = TrexClient(*open_port(settings, lambda plain: logged(writer.record, plain, clock)))
        try:
            client.detect_echo()
            identify(client)
            state = read_everything(client.request, has_crc=client.has_crc)
            status = json.dumps(board_report(client, state), indent=2, ensure_ascii=False)
        finally:
            client.close()
    except StudioError as error:
        status, stored = f"The board could not be read: {error}", ""
    else:
        stored = write_settings(settings_of(state))
    writer.close()
    return {
        "status.txt": lambda: status + "\n",
        "settings.txt": lambda: stored,
        "traffic.txt": lambda: writer.text,
    }
