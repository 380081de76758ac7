"""Commands `list` and `find`."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import click
from serial.tools import list_ports

from trex_gui.composition import PLUGINS
from trex_gui.core.cli import (
    CommandFailed,
    Interruption,
    ProgressLine,
    json_option,
    port_option,
    print_json,
    say,
    timeout_option,
    traffic_option,
)
from trex_gui.core.discovery.prober import ScanProgress
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.host import host
from trex_gui.core.plugin import Lazy, PortAnswer
from trex_gui.core.timing import Timeouts, seconds_left
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.urls import is_served
from trex_gui.devices.trex.cli.common import link_options


def _ports(selected: str | None) -> list[str]:
    if selected:
        return [selected]
    ports = sorted(port.device for port in list_ports.comports())
    if not ports:
        say("This computer has no serial port. Use --port for a port of another kind.")
    return ports


@click.command("list")
@link_options
@json_option
def list_command(as_json: bool, **options: Any) -> None:
    """List the ports of this computer and the devices on them.

    Never moves the motors of a TReX or Aracna. With --port, probes only that port. To find a board
    whose line settings are unknown, use `trexcmd find`. If other devices share the line, pass
    their numbers with --reserve.
    """
    rows: list[dict[str, Any]] = []
    unreachable = False
    for url in _ports(options["port"]):
        try:
            answer = _identify(url, options)
        except PortUnavailable as error:
            answer, unreachable = PortAnswer(str(error)), True
        rows.append({"port": url, **asdict(answer)})
        if not as_json:
            click.echo(f"{url}\t{answer.text}")
    if as_json:
        print_json(rows)
    if unreachable and options["port"]:
        raise CommandFailed(f"{options['port']} could not be opened.")


def _identify(url: str, options: Mapping[str, Any]) -> PortAnswer:
    """Return the answer of the first device that replies, or the combined texts of all kinds."""
    texts = []
    for plugin in PLUGINS:
        answer = plugin.port_reports.load().identify(url, options)
        if answer.product is not None:
            return answer
        texts.append(answer.text)
        if options["reserve"]:
            break  # send nothing to other kinds of devices
    return PortAnswer("; ".join(filter(None, texts)))


@click.command("find")
@port_option
@click.option(
    "--full",
    is_flag=True,
    help="Also try every CRC polynomial, which takes a few minutes, and every device number "
    "wherever a device replies. All boards on the line must use the same baud rate.",
)
@timeout_option
@traffic_option(Lazy("trex_gui.devices.trex.session.traffic_decoder:TrexDecoder"), is_search=True)
@json_option
def find_command(port: str | None, full: bool, extra_timeout: float, as_json: bool) -> None:
    """Find a board whose serial settings are unknown.

    Probes one port or all ports, first for a TReX at the likely baud rates, then for an Aracna,
    then for a TReX at every baud rate with every parity and with CRC-7. Prints the options needed
    to connect to the board. Never moves the motors or changes the settings of a TReX or Aracna. If
    devices of other kinds share the line, use `boards --reserve` instead, because such devices may
    react to the probes. A TReX at another rate latches UART errors, and stops its motors if it is
    configured to do so.
    """
    probers = {plugin.key: plugin.prober.load() for plugin in PLUGINS}
    reports = {plugin.key: plugin.port_reports.load() for plugin in PLUGINS}
    if is_served(port or ""):
        raise click.UsageError(
            "The server of this board knows its line settings. Connect without searching."
        )
    rows: list[dict[str, Any]] = []
    with Interruption() as interrupted:
        for url in _ports(port):
            if interrupted:
                break
            say(f"Searching {url} ...")
            with ProgressLine("Searching") as line:
                start = host().clock()

                def show(
                    step: ScanProgress, line: ProgressLine = line, start: float = start
                ) -> None:
                    left = seconds_left(host().clock() - start, step.done, step.total)
                    text = "" if left is None else f", at most {left} s left"
                    line(step.done, step.total, f"{step.kind} at {step.line.short}{text}")

                search = scan_port(
                    PortSettings(url, timeouts=Timeouts(extra=extra_timeout)),
                    probers,
                    full=full,
                    progress=show,
                    cancelled=interrupted.__bool__,
                    open_wire=host().open_transport,
                )
            for found in search.found:
                say(reports[search.device].describe(found))
                settings = found.settings
                row = {
                    "port": settings.url,
                    "baud": settings.line.baud,
                    "stop_bits": settings.line.stop_bits,
                    "device_number": found.device_number,
                    "echo": found.echo,
                    "note": found.note,
                }
                rows.append({**row, **reports[search.device].row(found)})
                if not as_json:
                    click.echo(rows[-1]["options"])
            if not search.found and not search.cancelled:
                for text in search.lines:
                    say(text)
    if as_json:
        print_json(rows)
    if not rows:
        raise CommandFailed("Search cancelled." if interrupted else "No board was found.")
