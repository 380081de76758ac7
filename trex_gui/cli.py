"""trexcmd: the board from the shell, without Qt.

Data goes to stdout, messages to stderr. Exit codes: 0 done, 1 the device or a file refused,
2 wrong usage.
"""

import contextlib
import json
from collections.abc import Callable, Iterator
from typing import Any, TypeVar

import click
from serial.tools import list_ports

from trex_gui import __version__
from trex_gui.link.client import Client
from trex_gui.link.doctor import why_no_board
from trex_gui.link.explain import MODE_TEXT, who_controls
from trex_gui.link.reading import DeviceState, ask, read_everything
from trex_gui.link.settings import LinkSettings
from trex_gui.link.stopping import stop_and_prove
from trex_gui.link.telemetry import StatusNews, StatusReader
from trex_gui.link.transport import SerialTransport
from trex_gui.link.writing import write_parameter
from trex_gui.protocol.commands import (
    GetCurrents,
    GetParameter,
    GetRawChannels,
    GetRemappedChannels,
    GetSignature,
    Signature,
)
from trex_gui.protocol.errors import BadReply, BadRequest, NoReply, PortUnavailable, TrexError
from trex_gui.protocol.flags import (
    CHANNELS,
    STATUS_MEANING,
    UART_MEANING,
    Status,
    UartError,
)
from trex_gui.protocol.framing import Framing
from trex_gui.protocol.line_settings import Detection, LineSettings
from trex_gui.protocol.parameters import ParameterSpec, parameters_of

FunctionT = TypeVar("FunctionT", bound=Callable[..., Any])

_RAW_SILENCE = 0.25
"""Seconds without a byte after which `raw` takes an answer to be whole."""


class _Refused(click.ClickException):
    """The device, the line or a file said no: exit code 1."""

    exit_code = 1


class _Usage(click.UsageError):
    """What was asked for makes no sense: exit code 2."""


def _hexadecimal(text: str) -> int:
    try:
        return int(text, 16)
    except ValueError:
        raise _Usage(f"{text!r} is not a hexadecimal number such as 89.") from None


def _link_options(function: FunctionT) -> FunctionT:
    """Add the options that say how to reach the board."""
    for option in reversed(
        (
            click.option(
                "--port",
                envvar="TREX_PORT",
                metavar="URL",
                help="Port of the board, such as /dev/ttyUSB0, COM3, socket://host:port or "
                "rfc2217://host:port. TREX_PORT in the environment stands for it.",
            ),
            click.option(
                "--baud", type=int, default=19200, show_default=True, help="Baud rate in bit/s."
            ),
            click.option(
                "--parity",
                type=click.Choice(["none", "even", "odd"]),
                default="none",
                show_default=True,
            ),
            click.option("--crc", is_flag=True, help="Every packet ends in a CRC-7."),
            click.option(
                "--polynomial",
                metavar="HEX",
                default="89",
                show_default=True,
                help="CRC-7 polynomial, 80 to FF.",
            ),
            click.option("--stop-bits", type=click.IntRange(1, 2), default=1, show_default=True),
            click.option(
                "--device",
                type=click.IntRange(0, 127),
                default=7,
                show_default=True,
                help="Device number, used with the expanded protocol.",
            ),
            click.option(
                "--protocol",
                type=click.Choice(["compact", "expanded"]),
                default="compact",
                show_default=True,
                help="Expanded (Pololu) packets reach one board of several.",
            ),
            click.option(
                "--timeout",
                "patience",
                type=click.FloatRange(0),
                default=0.0,
                metavar="S",
                help="Seconds to wait longer than wire and board need.",
            ),
        )
    ):
        function = option(function)
    return function


def _settings(options: dict[str, Any], url: str | None = None) -> LinkSettings:
    """Make link settings of the common options.

    Raises:
        _Usage: they contradict each other, or there is no port.
    """
    url = url or options["port"]
    if not url:
        raise _Usage("Which port? Give --port, or set TREX_PORT; `trexcmd list` shows them.")
    if options["crc"] and options["parity"] != "none":
        raise _Usage("A TReX has either CRC or parity, not both.")
    detection = {"none": Detection.NONE, "even": Detection.EVEN, "odd": Detection.ODD}
    line = LineSettings(
        options["baud"],
        Detection.CRC7 if options["crc"] else detection[options["parity"]],
        options["stop_bits"],
    )
    number = options["device"] if options["protocol"] == "expanded" else None
    try:
        line.to_wire()
        polynomial = _hexadecimal(options["polynomial"])
        Framing(number, polynomial)
    except BadRequest as error:
        raise _Usage(str(error)) from error
    return LinkSettings(url, line, number, polynomial, options["patience"])


@contextlib.contextmanager
def _open(settings: LinkSettings) -> Iterator[Client]:
    """Open the line; whatever goes wrong on it ends the program with a sentence."""
    try:
        client = Client(SerialTransport(settings), settings)
        try:
            client.detect_echo()
            yield client
            client.drain()
        finally:
            client.close()
    except TrexError as error:
        raise _Refused(str(error)) from error


def _signature(client: Client) -> Signature:
    try:
        return ask(client.request, GetSignature())
    except (NoReply, BadReply) as error:
        raise why_no_board(client.settings, echo=client.echo, error=error) from error


def _spec(client: Client, name: str) -> ParameterSpec:
    signature = _signature(client)
    return parameters_of(signature.model.key, signature.firmware)[name]


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(__version__, prog_name="trexcmd")
def main() -> None:
    """Look at, set up and drive a Pololu TReX or TReX Jr motor controller."""


@main.command("list")
@_link_options
def list_command(**options: Any) -> None:
    """List the ports of this computer and what answers on them.

    Only asks; never moves a motor. With --port, looks at that port alone.
    """
    ports = (
        [options["port"]] if options["port"] else sorted(p.device for p in list_ports.comports())
    )
    if not ports:
        click.echo("This computer has no serial ports; give --port for another kind.", err=True)
    unreachable = False
    for url in ports:
        settings = _settings(options, url)
        try:
            answer = _what_answers(settings)
        except PortUnavailable as error:
            answer, unreachable = str(error), True
        click.echo(f"{url}\t{answer}")
    if unreachable and options["port"]:
        raise _Refused(f"{options['port']} could not be looked at.")


def _what_answers(settings: LinkSettings) -> str:
    """Return in a few words what a port holds.

    Raises:
        PortUnavailable: it cannot be opened, or went away.
    """
    client = Client(SerialTransport(settings), settings)
    try:
        client.detect_echo()
        return str(ask(client.request, GetSignature()))
    except NoReply:
        return "echo only" if client.echo else "nothing answers"
    except BadReply as error:
        return f"no TReX: {error}"
    finally:
        client.close()


@main.command()
@_link_options
@click.option("--json", "as_json", is_flag=True, help="One JSON object instead of text.")
def status(as_json: bool, **options: Any) -> None:
    """Show what the board is, how it is set and what it measures.

    Reading the error bits clears them in the board.
    """
    with _open(_settings(options)) as client:
        _signature(client)
        state = read_everything(client.request)
        news = StatusReader(client.transport.clock).read(client.request)
        report = _status_report(client, state, news)
    if as_json:
        click.echo(json.dumps(report, indent=2))
        return
    for key, value in report.items():
        if isinstance(value, str):
            click.echo(f"{key.replace('_', ' ').capitalize() + ':':22}{value}")
    click.echo("Channels:")
    for row in report["channels"]:
        physical = row["physical"] if row["raw"] is not None else "no signal"
        counts = "" if row["raw"] is None else f" ({row['raw']})"
        click.echo(f"  {row['channel']}  {physical}{counts}, remapped {row['remapped']}")
    click.echo("Errors: " + (", ".join(report["errors"]) or "none"))
    click.echo("Parameters:")
    for key, row in report["parameters"].items():
        click.echo(f"  {key:28}{row['value']:>4}  {row['text']}")


def _status_report(client: Client, state: DeviceState, news: StatusNews | None) -> dict[str, Any]:
    raw = ask(client.request, GetRawChannels())
    remapped = ask(client.request, GetRemappedChannels())
    currents = ask(client.request, GetCurrents())
    unit = state.signature.model.current_unit
    status_bits = news.status if news else Status(0)
    uart_bits = news.uart if news else UartError(0)
    names = [name for bit, (name, _) in STATUS_MEANING.items() if bit & status_bits]
    names += [name for bit, (name, _) in UART_MEANING.items() if bit & uart_bits]
    return {
        "product": state.signature.model.name,
        "firmware": state.signature.firmware,
        "mode": MODE_TEXT[state.mode],
        "in_control": who_controls(
            state.mode, state.serial_controls, joint=state.parameters.get("motor_mode") == 1
        ),
        "serial_controls": state.serial_controls,
        "motor_1_current": f"{currents[0] * unit:.2f} A",
        "motor_2_current": f"{currents[1] * unit:.2f} A",
        "channels": [
            {
                "channel": channel,
                "raw": count,
                "physical": None if count is None else state.source.text(count),
                "remapped": remapped[channel],
            }
            for channel in CHANNELS
            for count in (raw[channel],)
        ],
        "errors": names,
        "parameters": {
            key: {"value": wire, "text": state.specs[key].text(wire)}
            for key, wire in state.parameters.items()
        },
    }


@main.command("get")
@_link_options
@click.argument("name")
@click.option("--json", "as_json", is_flag=True, help="One JSON object instead of text.")
def get_command(name: str, as_json: bool, **options: Any) -> None:
    """Show one parameter, such as serial_timeout: wire value and what it means."""
    with _open(_settings(options)) as client:
        spec = _spec(client, name)
        if not spec.readable:
            raise BadRequest(f"{spec.name} can only be written")
        wire = ask(client.request, GetParameter(spec.number))
    if as_json:
        click.echo(json.dumps({"name": spec.key, "value": wire, "text": spec.text(wire)}))
    else:
        click.echo(f"{wire}\t{spec.text(wire)}")


@main.command("set", context_settings={"ignore_unknown_options": True})
@_link_options
@click.argument("name")
@click.argument("value")
def set_command(name: str, value: str, **options: Any) -> None:
    """Store one parameter and read it back.

    VALUE is a wire value as in settings files (15), or one with its unit or in words
    ("1.5 s", "off").
    """
    with _open(_settings(options)) as client:
        spec = _spec(client, name)
        is_wire = value.strip().isdecimal() and len(value) < 10
        wire = int(value) if is_wire else spec.wire(value)
        stored = write_parameter(client.request, spec, wire)
    click.echo(f"{stored}\t{spec.text(stored)}")
    if spec.needs_power_cycle:
        click.echo("Stored; it takes effect when the board is switched off and on.", err=True)


@main.command()
@_link_options
def stop(**options: Any) -> None:
    """Brake both motors and switch the auxiliary motor off, until the board confirms it."""
    with _open(_settings(options)) as client:
        reader = StatusReader(client.transport.clock)
        if not stop_and_prove(client, reader).proved:
            _signature(client)  # says why nothing answers
            raise NoReply(
                "The stop was sent, but the board reports errors on the line each time. "
                "If a motor still turns, cut its power."
            )
    click.echo("Stopped.", err=True)


@main.command()
@_link_options
@click.argument("packet")
def raw(packet: str, **options: Any) -> None:
    """Send the bytes of PACKET ("86 1F") as they are, and show what comes back."""
    try:
        data = bytes.fromhex(packet)
    except ValueError as error:
        raise _Usage(f'"{packet}" is not hexadecimal bytes such as "86 1F".') from error
    with _open(_settings(options)) as client:
        transport = client.transport
        transport.discard()
        transport.write(data)
        seconds = client.settings.line.seconds(len(data)) + _RAW_SILENCE
        received = bytearray()
        while chunk := transport.read(1, seconds):
            received += chunk
            seconds = _RAW_SILENCE
    click.echo(received.hex(" ").upper())


if __name__ == "__main__":
    main()
