"""trex-sim: a virtual TReX that any program can open as a serial port."""

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from trex_gui import __version__
from trex_gui.core.errors import StudioError
from trex_gui.core.simulator.endpoint import Endpoint, TcpEndpoint, default_endpoint_is_tcp
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.simulator.eeprom import Eeprom
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedLine

if TYPE_CHECKING:  # `--help` needs none of this
    from trex_gui.core.simulator.server import Wire
    from trex_gui.devices.trex.simulator.demo import Demo

_MODELS = [model.key for model in device_table().models]
_FIRMWARE = sorted({version for model in device_table().models for version in model.firmware})
_MOST_MOTORS = 8

_OF_A_TREX = ("model", "firmware", "mode", "mix", "echo", "eeprom", "devices", "demo")
"""Options that an Aracna has nothing for."""


@dataclass(frozen=True, slots=True)
class DeviceOption:
    """What `--device` says of one board: its number and model, `None` where it does not."""

    number: int | None = None
    model: str | None = None


def _read_device(text: str) -> DeviceOption:
    """Read NUMBER[:MODEL]."""
    number, _, model = text.partition(":")
    if not (number.isascii() and number.isdigit() and int(number) <= 127):
        raise click.BadParameter(f"a device number is 0 to 127, not {number!r}")
    if model and model not in _MODELS:
        raise click.BadParameter(f"a model is {' or '.join(_MODELS)}, not {model!r}")
    return DeviceOption(int(number), model or None)


def _read_address(text: str) -> tuple[str, int]:
    """Read HOST:PORT; an IPv6 host stands in brackets."""
    host, _, port = text.rpartition(":")
    if not (port.isascii() and port.isdigit() and int(port) <= 0xFFFF):
        raise click.BadParameter(f"{text!r} is not HOST:PORT such as 127.0.0.1:0")
    return host.strip("[]") or "127.0.0.1", int(port)


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--model", type=click.Choice(_MODELS), default="trex", show_default=True)
@click.option("--firmware", type=click.Choice(_FIRMWARE), default="1.2", show_default=True)
@click.option(
    "--mode",
    type=click.Choice(["serial", "rc", "analog"]),
    default="serial",
    show_default=True,
    help="How the mode jumper is set.",
)
@click.option("--mix", is_flag=True, help="Set the mix jumper.")
@click.option("--echo", is_flag=True, help="Send back what comes, as the RS-232 connector does.")
@click.option("--unpaced", is_flag=True, help="Let bytes take no time on the wire.")
@click.option("--link", type=click.Path(path_type=Path), help="Name for the pseudo-terminal.")
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
    help="Serve a remote serial port (RFC 2217), the way to see the host's parity.",
)
@click.option(
    "--eeprom",
    type=click.Path(path_type=Path, dir_okay=False),
    help="File that keeps what the board stores. With several devices each has one of its own, "
    "its number before the suffix.",
)
@click.option(
    "--device",
    "devices",
    type=_read_device,
    metavar="NUMBER[:MODEL]",
    multiple=True,
    help="A board with this device number; repeat it for several on one wire.",
)
@click.option("--seed", type=int, default=0, show_default=True, help="For all noise.")
@click.option("--demo", is_flag=True, help="Move the sticks gently and load the motors.")
@click.option("--aracna", is_flag=True, help="Simulate an Aracna instead, at 38400 8N1.")
@click.option(
    "--motors",
    type=click.IntRange(1, _MOST_MOTORS),
    help="How many the Aracna has; 2 make it one of version 0.  [default: 8]",
)
@click.version_option(__version__, prog_name="trex-sim")
def main(
    *,
    model: str,
    firmware: str,
    mode: str,
    mix: bool,
    echo: bool,
    unpaced: bool,
    link: Path | None,
    tcp: tuple[str, int] | None,
    rfc2217: tuple[str, int] | None,
    eeprom: Path | None,
    devices: tuple[DeviceOption, ...],
    seed: int,
    demo: bool,
    aracna: bool,
    motors: int | None,
) -> None:
    """Simulate TReX motor controllers, or an Aracna, on a pseudo-terminal or a TCP port.

    Prints "ready URL" with what a program has to open, then takes control lines on standard
    input and answers each with "ok ..." or "error ...": channel, jumper, power, load, current,
    fault, battery, eeprom, factory, line, show, quit. Each says what it wants when it is given
    too little. With several devices they begin with one of them, as in "@9 power cycle".
    An Aracna takes others: reset, power, servo, line, show, quit.
    """
    if sum(option is not None for option in (link, tcp, rfc2217)) > 1:
        raise click.UsageError("only one of --link, --tcp and --rfc2217")
    if aracna:
        _refuse(_OF_A_TREX, "is for a TReX and means nothing with --aracna")
    else:
        _refuse(("motors",), "means something only with --aracna")
    if len({device.number for device in devices}) < len(devices):
        raise click.UsageError("each --device needs a number of its own; control lines use it")
    try:
        if aracna:
            simulation = simulate_aracna(motors, paced=not unpaced, seed=seed)
        else:
            simulation = simulate_trex(
                model=model,
                firmware=firmware,
                mode=mode,
                mix=mix,
                echo=echo,
                paced=not unpaced,
                eeprom=eeprom,
                devices=devices,
                seed=seed,
                demo=demo,
            )
        with closing(_endpoint(link, tcp, rfc2217, simulation.baud)) as endpoint:
            _serve(simulation, endpoint)
    except StudioError as error:
        raise click.ClickException(str(error)) from error


@dataclass(frozen=True, slots=True)
class Simulation:
    """A simulated line in virtual time, what obeys its control lines, and what moves its sticks.

    `baud` is the rate of a host that fits.
    """

    line: "Wire"
    control: Callable[[str], str]
    baud: int
    demos: "Sequence[Demo]" = ()


def simulate_trex(
    *,
    model: str = "trex",
    firmware: str = "1.2",
    mode: str = "serial",
    mix: bool = False,
    echo: bool = False,
    paced: bool = True,
    eeprom: Path | None = None,
    devices: Sequence[DeviceOption] = (),
    seed: int = 0,
    demo: bool = False,
) -> Simulation:
    """Make one TReX, or several on one wire; the arguments are the options of the command line.

    Raises:
        TrexError: the EEPROM file cannot be read.
    """
    from trex_gui.devices.trex.simulator.control import control  # noqa: PLC0415 - `--help` needs none of this
    from trex_gui.devices.trex.simulator.demo import Demo  # noqa: PLC0415

    boards = [
        Board(
            device.model or model,
            firmware,
            eeprom=_eeprom(eeprom, device, device.model or model, len(devices)),
            mode=mode,
            mix=mix,
            seed=seed + index,
        )
        for index, device in enumerate(devices or [DeviceOption()])
    ]
    line = SimulatedLine(boards, echo=echo, paced=paced, seed=seed)
    demos = [Demo(board) for board in boards] if demo else []
    return Simulation(line, partial(control, line), boards[0].memory.baud, demos)


def simulate_aracna(motors: int | None, *, paced: bool, seed: int) -> Simulation:
    """Make a robot with so many motors, as many as there can be unless said."""
    from trex_gui.devices.aracna.simulator.control import control  # noqa: PLC0415 - nor this
    from trex_gui.devices.aracna.simulator.line import AracnaLine  # noqa: PLC0415

    line = AracnaLine(_MOST_MOTORS if motors is None else motors, paced=paced, seed=seed)
    return Simulation(line, partial(control, line), line.own_settings.baud)


def _refuse(names: Sequence[str], why: str) -> None:
    """Refuse options that somebody has given.

    Raises:
        click.UsageError: one of them was.
    """
    context = click.get_current_context()
    for parameter in context.command.params:
        given = context.get_parameter_source(parameter.name or "")
        if parameter.name in names and given is not ParameterSource.DEFAULT:
            raise click.UsageError(f"{parameter.opts[0]} {why}")


def _eeprom(path: Path | None, device: DeviceOption, model: str, count: int) -> Eeprom:
    """Return the memory of a board; one that a file remembers keeps its device number."""
    if path is not None and count > 1:
        path = path.with_name(f"{path.stem}-{device.number}{path.suffix}")
    is_fresh = path is None or not path.exists()
    eeprom = Eeprom(model) if path is None else Eeprom.open(path, model)
    number, wanted = eeprom["device_number"], device.number
    if wanted is None or wanted == number:
        return eeprom
    if is_fresh:
        eeprom.write("device_number", wanted)
    else:
        click.echo(f"{path} says that this board is device {number}; it stays so", err=True)
    return eeprom


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
    # Imported where wanted: one needs pyserial, the other a system with pseudo-terminals.
    if rfc2217 is not None:
        from trex_gui.core.simulator.rfc2217_endpoint import Rfc2217Endpoint  # noqa: PLC0415

        return Rfc2217Endpoint(*rfc2217, baud)
    if default_endpoint_is_tcp():
        raise click.UsageError("this system has no pseudo-terminals; use --tcp or --rfc2217")
    from trex_gui.core.simulator.pty_endpoint import PtyEndpoint  # noqa: PLC0415

    return PtyEndpoint(link, baud)


def _serve(simulation: Simulation, endpoint: Endpoint) -> None:
    from trex_gui.core.simulator.server import Server  # noqa: PLC0415

    Server(simulation.line, endpoint, simulation.control, simulation.demos).run()


if __name__ == "__main__":
    main(prog_name="trex-sim")
