"""list, find: which ports there are, what answers on them, how a lost board is set."""

import json
from functools import partial
from typing import Any

import click
from serial.tools import list_ports

from trex_gui.core.cli.console import CommandFailed, Interruption, ProgressLine, say
from trex_gui.core.cli.host import host
from trex_gui.core.discovery.prober import Evidence, FoundDevice, ScanProgress
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.errors import BadReply, NoReply, PortUnavailable
from trex_gui.core.timing import Timeouts
from trex_gui.devices.aracna.cli import scan
from trex_gui.devices.trex.cli.common import (
    as_options,
    json_option,
    link_options,
    link_settings,
    port_option,
    timeout_option,
)
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import ask
from trex_gui.devices.trex.discovery.prober import TREX_PROBER
from trex_gui.devices.trex.discovery.results import FoundBoard
from trex_gui.devices.trex.protocol.commands import GetSignature, Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

_SEEKS = {"trex": TREX_PROBER, "aracna": scan.ARACNA_PROBER}
"""What is looked for, the commonest first; see `link.seeking` for the order of the questions."""


def _ports(chosen: str | None) -> list[str]:
    if chosen:
        return [chosen]
    ports = sorted(port.device for port in list_ports.comports())
    if not ports:
        say("This computer has no serial ports; give --port for another kind.")
    return ports


@click.command("list")
@link_options
@json_option
def list_command(as_json: bool, **options: Any) -> None:
    """List the ports of this computer and what answers on them.

    Only asks; never moves a motor. With --port, looks at that port alone. A board that is not
    set to these line settings is found by `trexcmd find`. An Aracna has only one setting.
    """
    rows: list[dict[str, Any]] = []
    unreachable = False
    for url in _ports(options["port"]):
        settings = link_settings(options, url)
        row: dict[str, Any] = {"port": url, "product": None, "firmware": None}
        try:
            answer = _what_answers(settings)
            known = isinstance(answer, Signature)
            seen = None if known else scan.look(url, settings.timeouts.extra)
        except PortUnavailable as error:
            row["answer"], unreachable = str(error), True
        else:
            row["answer"] = str(answer)
            if isinstance(answer, Signature):
                row |= {"product": answer.model.name, "firmware": answer.firmware}
            elif seen is not None and seen.found:
                row |= scan.listed(seen.found[0])
            elif seen is not None and (diagnosis := seen.diagnosis()).telling > Evidence.ECHO:
                row["answer"] += f"; {diagnosis.text}"
        rows.append(row)
        if not as_json:
            click.echo(f"{url}\t{row['answer']}")
    if as_json:
        click.echo(json.dumps(rows, indent=2, ensure_ascii=False))
    if unreachable and options["port"]:
        raise CommandFailed(f"{options['port']} could not be looked at.")


def _what_answers(settings: ConnectionSettings) -> Signature | str:
    """Return in a few words what a port holds.

    Raises:
        PortUnavailable: it cannot be opened, or went away.
    """
    client = TrexClient(host().open_transport(settings), settings)
    try:
        client.detect_echo()
        return ask(client.request, GetSignature())
    except NoReply:
        return "echo only" if client.echo else "nothing answers"
    except BadReply as error:
        return f"no TReX: {error}"
    finally:
        client.close()


@click.command("find")
@port_option
@click.option(
    "--full",
    is_flag=True,
    help="Try every CRC polynomial too (some minutes), and ask for every device number where "
    "something answers. All boards on the line must run at the same rate.",
)
@timeout_option
@json_option
def find_command(port: str | None, full: bool, patience: float, as_json: bool) -> None:
    """Find a board whose serial settings are unknown.

    Looks for a TReX at the likely baud rates, then for an Aracna, then for a TReX at every baud
    rate with every parity and with CRC-7, on one port or on all; prints the options that reach
    the board. Never moves a motor, and changes nothing; a TReX that hears bytes at a wrong rate
    latches UART errors, and stops its motors where it is set to do so.
    """
    rows: list[dict[str, Any]] = []
    with Interruption() as interrupted:
        for url in _ports(port):
            if interrupted:
                break
            say(f"Searching {url} ...")
            with ProgressLine(f"Searching {url}") as line:
                search = scan_port(
                    ConnectionSettings(url, timeouts=Timeouts(extra=patience)),
                    _SEEKS,
                    full=full,
                    progress=partial(_show, line),
                    cancelled=interrupted.__bool__,
                    open_wire=host().open_transport,
                )
            for found in search.found:
                rows.append(_report(found))
                if not as_json:
                    click.echo(rows[-1]["options"])
            if not search.found and not search.cancelled:
                for text in search.lines:
                    say(text)
    if as_json:
        click.echo(json.dumps(rows, indent=2, ensure_ascii=False))
    if not rows:
        raise CommandFailed("The search was broken off." if interrupted else "No board was found.")


def _show(line: ProgressLine, step: ScanProgress) -> None:
    line(step.done, step.total, f"{step.kind} at {step.line.text()}")


def _report(found: FoundDevice) -> dict[str, Any]:
    """Tell a person of a device; return what `find --json` says of it."""
    if isinstance(found, scan.FoundRobot):
        say(scan.told(found))
        return scan.row(found)
    assert isinstance(found, FoundBoard)  # noqa: S101 - there is no third kind
    number = f", device number {found.device_number}" if found.device_number is not None else ""
    side = " (RS-232 side)" if found.echo else ""
    say(f"{found.signature} on {found.settings.text()}{number}{side}.")
    if found.note:
        say(found.note)
    return _row(found)


def _row(found: FoundBoard) -> dict[str, Any]:
    line = found.settings.line
    return {
        "port": found.settings.url,
        "product": found.signature.model.name,
        "firmware": found.signature.firmware,
        "baud": line.baud,
        "detection": line.detection.name.lower(),
        "polynomial": f"{found.settings.polynomial:02X}",
        "stop_bits": line.stop_bits,
        "device_number": found.device_number,
        "echo": found.echo,
        "note": found.note,
        "options": as_options(found.settings),
    }
