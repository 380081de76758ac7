"""The program trex-sim: a simulated device on a pseudo-terminal or TCP port."""

import sys
from pathlib import Path

import click
from click.core import ParameterSource

from trex_gui.composition import PLUGINS
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import StudioError
from trex_gui.core.simulator.endpoint import Endpoint, TcpEndpoint
from trex_gui.core.simulator.plugin import Simulation
from trex_gui.core.simulator.server import Server
from trex_gui.version import __version__

_SIMULATORS = {plugin.key: plugin.simulator.load() for plugin in PLUGINS}
_DEFAULT = PLUGINS[0].key

_HELP = """Simulate a device on a pseudo-terminal or a TCP port.

Prints "ready URL" with the address to open. Then reads control lines from standard input and
replies to each line with "ok ..." or "error ...".
"""


def _read_address(text: str) -> tuple[str, int]:
    """Parse HOST:PORT. IPv6 addresses are in brackets. The default host is 127.0.0.1."""
    host, _, port = text.rpartition(":")
    if not (port.isascii() and port.isdigit() and int(port) <= 0xFFFF):
        raise click.BadParameter(f"{text!r} is not HOST:PORT, such as 127.0.0.1:0.")
    return host.strip("[]") or "127.0.0.1", int(port)


def _device_options() -> list[click.Parameter]:
    options: list[click.Parameter] = []
    for key, simulator in _SIMULATORS.items():
        if key != _DEFAULT:
            options.append(click.Option([f"--{key}"], is_flag=True, help=simulator.help))
        options += simulator.options
    return options


@click.command(
    context_settings={"help_option_names": ["-h", "--help"]},
    help=f"{_HELP}\n{_SIMULATORS[_DEFAULT].help}",
    params=_device_options(),
)
@click.option("--unpaced", is_flag=True, help="Transmit bytes without a delay.")
@click.option("--seed", type=int, default=0, show_default=True, help="Seed of the random noise.")
@click.option(
    "--link",
    type=FileName(path_type=Path),
    help="Create a symbolic link with this name to the pseudo-terminal.",
)
@click.option(
    "--tcp",
    type=_read_address,
    metavar="HOST:PORT",
    help="Serve raw bytes over TCP. Port 0 selects a free port.",
)
@click.option(
    "--rfc2217",
    type=_read_address,
    metavar="HOST:PORT",
    help="Serve a remote serial port (RFC 2217). Only this kind of port tells the simulator the "
    "host's parity.",
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
    if sum(option is not None for option in (link, tcp, rfc2217)) > 1:
        raise click.UsageError("Use only one of --link, --tcp and --rfc2217.")
    try:
        simulation = simulate(context)
        baud = simulation.line.host_format.baud
        Server(simulation, _endpoint(link, tcp, rfc2217, baud)).run()
    except StudioError as error:
        raise click.ClickException(str(error)) from error


def simulate(context: click.Context) -> Simulation:
    """Create the simulation.

    Raises:
        UsageError: an option belongs to another device.
    """
    options = context.params
    device = next((key for key in _SIMULATORS if options.get(key)), _DEFAULT)
    for key, simulator in _SIMULATORS.items():
        for option in simulator.options:
            source = context.get_parameter_source(option.name or "")
            if key != device and source is not ParameterSource.DEFAULT:
                raise click.UsageError(f"{option.opts[0]} does not apply to the device {device}.")
    selected = _SIMULATORS[device]
    values = {option.name: options[option.name] for option in selected.options if option.name}
    return selected.build(paced=not options["unpaced"], seed=options["seed"], **values)


def _endpoint(
    link: Path | None, tcp: tuple[str, int] | None, rfc2217: tuple[str, int] | None, baud: int
) -> Endpoint:
    has_pseudo_terminals = sys.platform != "win32"
    if tcp is None and rfc2217 is None and link is None and not has_pseudo_terminals:
        tcp = ("127.0.0.1", 0)
    if tcp is not None:
        return TcpEndpoint(*tcp)
    # Imported on demand: RFC 2217 needs pyserial, and PtyEndpoint a system with pseudo-terminals.
    if rfc2217 is not None:
        from trex_gui.core.simulator.rfc2217_endpoint import Rfc2217Endpoint  # noqa: PLC0415

        return Rfc2217Endpoint(*rfc2217, baud)
    if not has_pseudo_terminals:
        raise click.UsageError("This system has no pseudo-terminals. Use --tcp or --rfc2217.")
    from trex_gui.core.simulator.pty_endpoint import PtyEndpoint  # noqa: PLC0415

    return PtyEndpoint(link, baud)


if __name__ == "__main__":
    main(prog_name="trex-sim")
