"""trex-sim: a simulated device that any program can open as a serial port."""

from contextlib import closing
from pathlib import Path

import click
from click.core import ParameterSource

from trex_gui import __version__
from trex_gui.core.errors import StudioError
from trex_gui.core.simulator.endpoint import Endpoint, TcpEndpoint, default_endpoint_is_tcp
from trex_gui.core.simulator.plugin import Simulation, SimulatorPlugin
from trex_gui.core.simulator.server import Server
from trex_gui.devices.aracna.simulator.command import SIMULATOR as ARACNA
from trex_gui.devices.trex.simulator.command import SIMULATOR as TREX

_SIMULATORS = (TREX, ARACNA)
"""The default device first."""

_HELP = """Simulate a device on a pseudo-terminal or a TCP port.

Prints "ready URL" with what a program opens, then reads control lines from standard input and
answers each with "ok ..." or "error ...".
"""


def _read_address(text: str) -> tuple[str, int]:
    """Read HOST:PORT; an IPv6 host is in brackets."""
    host, _, port = text.rpartition(":")
    if not (port.isascii() and port.isdigit() and int(port) <= 0xFFFF):
        raise click.BadParameter(f"{text!r} is not HOST:PORT such as 127.0.0.1:0")
    return host.strip("[]") or "127.0.0.1", int(port)


def _key(plugin: SimulatorPlugin) -> str:
    return plugin.flag.removeprefix("--").replace("-", "_")


@click.command(
    context_settings={"help_option_names": ["-h", "--help"]},
    help="\n".join([_HELP, *(plugin.help for plugin in _SIMULATORS if not plugin.flag)]),
    params=[
        option
        for plugin in _SIMULATORS
        for option in (
            *([click.Option([plugin.flag], is_flag=True, help=plugin.help)] if plugin.flag else []),
            *plugin.options,
        )
    ],
)
@click.option("--unpaced", is_flag=True, help="Let bytes take no time on the wire.")
@click.option("--seed", type=int, default=0, show_default=True, help="For all noise.")
@click.option("--link", type=click.Path(path_type=Path), help="Link to the pseudo-terminal.")
@click.option(
    "--tcp",
    type=_read_address,
    metavar="HOST:PORT",
    help="Serve raw bytes over TCP; port 0 picks one.",
)
@click.option(
    "--rfc2217",
    type=_read_address,
    metavar="HOST:PORT",
    help="Serve a remote serial port (RFC 2217), the only way to see the host's parity.",
)
@click.version_option(__version__, prog_name="trex-sim")
@click.pass_context
def main(
    context: click.Context,
    /,
    *,
    link: Path | None,
    tcp: tuple[str, int] | None,
    rfc2217: tuple[str, int] | None,
    **_options: object,
) -> None:
    """Simulate a device until it is told to quit."""
    if sum(option is not None for option in (link, tcp, rfc2217)) > 1:
        raise click.UsageError("only one of --link, --tcp and --rfc2217")
    try:
        simulation = simulate(context)
        baud = simulation.line.host_format.baud
        with closing(_endpoint(link, tcp, rfc2217, baud)) as endpoint:
            Server(simulation, endpoint).run()
    except StudioError as error:
        raise click.ClickException(str(error)) from error


def simulate(context: click.Context) -> Simulation:
    """Build the simulation that the options describe.

    Raises:
        click.UsageError: an option belongs to another device.
        StudioError: a file cannot be read.
    """
    options = context.params
    flagged = [plugin for plugin in _SIMULATORS if plugin.flag and options[_key(plugin)]]
    device = flagged[0] if flagged else _SIMULATORS[0]
    for plugin in _SIMULATORS:
        for option in plugin.options:
            given = context.get_parameter_source(option.name or "")
            if plugin is not device and given is not ParameterSource.DEFAULT:
                raise click.UsageError(f"{option.opts[0]} does not apply to {device.name}")
    values = {option.name: options[option.name] for option in device.options if option.name}
    return device.build(paced=not options["unpaced"], seed=options["seed"], **values)


def _endpoint(
    link: Path | None,
    tcp: tuple[str, int] | None,
    rfc2217: tuple[str, int] | None,
    baud: int,
) -> Endpoint:
    if tcp is None and rfc2217 is None and link is None and default_endpoint_is_tcp():
        tcp = ("127.0.0.1", 0)
    if tcp is not None:
        return TcpEndpoint(*tcp)
    # Imported on demand: one needs pyserial, the other a system with pseudo-terminals.
    if rfc2217 is not None:
        from trex_gui.core.simulator.rfc2217_endpoint import Rfc2217Endpoint  # noqa: PLC0415

        return Rfc2217Endpoint(*rfc2217, baud)
    if default_endpoint_is_tcp():
        raise click.UsageError("this system has no pseudo-terminals; use --tcp or --rfc2217")
    from trex_gui.core.simulator.pty_endpoint import PtyEndpoint  # noqa: PLC0415

    return PtyEndpoint(link, baud)


if __name__ == "__main__":
    main(prog_name="trex-sim")
