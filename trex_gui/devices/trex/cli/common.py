"""Options, connections and reports that several commands share."""

import contextlib
import difflib
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import click
from click.shell_completion import CompletionItem

from trex_gui.core.cli import (
    ProgressLine,
    all_options,
    hexadecimal,
    port_option,
    reported_errors,
    required_port,
    shell_words,
    timeout_option,
    traffic_option,
)
from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.core.host import OpenTransport, host
from trex_gui.core.plugin import Lazy, PortAnswer, PortReports
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.urls import is_served
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import read_reliably, read_signature, several_reply
from trex_gui.devices.trex.diagnosis import diagnose
from trex_gui.devices.trex.discovery import FoundBoard
from trex_gui.devices.trex.protocol.commands import GetParameter, GetSignature, Signature
from trex_gui.devices.trex.protocol.connection_settings import (
    FACTORY_NUMBER,
    ConnectionSettings,
    numbers_in,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.errors import (
    BoardElsewhere,
    ErrorCode,
    TrexBadReplyError,
    TrexError,
)
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL, Framing
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import (
    ParameterKey,
    ParameterSpec,
    parameter_number,
    parameters_of,
)

# --- Options ----------------------------------------------------------------------------


def complete_parameter(
    _ctx: click.Context, _param: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    rows = {row["key"]: row["name"] for row in device_table().rows}
    return [
        CompletionItem(key, help=name) for key, name in rows.items() if key.startswith(incomplete)
    ]


crc_option = click.option("--crc", is_flag=True, help="End every packet with a CRC-7.")
polynomial_option = click.option(
    "--polynomial",
    metavar="HEX",
    default="89",
    show_default=True,
    help="CRC-7 polynomial, 80 to FF.",
)
link_options = all_options(
    port_option,
    click.option(
        "--baud",
        type=int,
        default=19200,
        show_default=True,
        help="Baud rate in bit/s.",
    ),
    click.option(
        "--parity",
        type=click.Choice(["none", "even", "odd"]),
        default="none",
        show_default=True,
        help="Parity bit of each byte. Cannot be combined with --crc.",
    ),
    crc_option,
    polynomial_option,
    click.option(
        "--stop-bits",
        type=click.IntRange(1, 2),
        default=1,
        show_default=True,
        help="Stop bits of each byte.",
    ),
    click.option(
        "--device",
        type=click.IntRange(0, 127),
        help="Device number of the board. Implies --protocol expanded.  "
        f"[default: {FACTORY_NUMBER}]",
    ),
    click.option(
        "--protocol",
        type=click.Choice(["compact", "expanded"]),
        help="The expanded (Pololu) protocol addresses one of several boards. Compact packets "
        "reach every board on the line.  [default: compact]",
    ),
    click.option(
        "--reserve",
        metavar="NUMBERS",
        default="",
        help="Device numbers of other devices on the line, such as 0,1. Implies --protocol "
        "expanded.",
    ),
    timeout_option,
    traffic_option(Lazy("trex_gui.devices.trex.session.traffic_decoder:TrexDecoder")),
)


def link_settings(options: Mapping[str, Any], url: str | None = None) -> ConnectionSettings:
    """Create connection settings from the common options. Raises UsageError for a conflict."""
    url = url or required_port(options["port"])
    if options["crc"] and options["parity"] != "none":
        raise click.UsageError("A TReX can use either CRC or parity, not both.")
    detection = Detection["CRC7" if options["crc"] else options["parity"].upper()]
    line = LineSettings(options["baud"], detection, options["stop_bits"])
    number, protocol = options["device"], options["protocol"]
    if options["reserve"] or protocol == "expanded" or (protocol is None and number is not None):
        number = FACTORY_NUMBER if number is None else number
    else:
        number = None
    timeouts = Timeouts(extra=options["extra_timeout"])
    try:
        line.to_wire()
        polynomial = hexadecimal(options["polynomial"])
        reserved = numbers_in(options["reserve"])
        settings = ConnectionSettings(url, line, number, polynomial, reserved, timeouts=timeouts)
        Framing(settings.framing.device_number, polynomial)
    except ValueError as error:
        raise click.UsageError(str(error)) from error
    return settings


boards_option = click.option(
    "--boards",
    metavar="NUMBERS",
    default="",
    help="Device numbers of several boards to address at once, such as 7,9.",
)


def grouped(settings: ConnectionSettings, boards: str) -> ConnectionSettings:
    """Return settings for a group of boards. Raises UsageError if the numbers are invalid."""
    if not boards:
        return settings
    try:
        return settings.with_group(tuple(sorted(numbers_in(boards))))
    except ValueError as error:
        raise click.UsageError(f"--boards: {error}") from error


def as_options(settings: ConnectionSettings) -> str:
    line = settings.line
    words = ["--port", settings.url, "--baud", str(line.baud)]
    if line.has_crc:
        words.append("--crc")
        if settings.polynomial != DEFAULT_POLYNOMIAL:
            words += ["--polynomial", f"{settings.polynomial:02X}"]
    elif line.detection is not Detection.NONE:
        words += ["--parity", line.detection.name.lower()]
    if line.stop_bits == 2:
        words += ["--stop-bits", "2"]
    if settings.device_number is not None:
        words += ["--protocol", "expanded", "--device", str(settings.device_number)]
    if settings.reserved:
        words += ["--reserve", settings.reserved_text]
    return shell_words(*words)


# --- Measurements in JSON ---------------------------------------------------------------

PHYSICAL_KEYS = {InputSource.RC: "pulse_us", InputSource.ANALOG: "voltage_V"}


def physical_value(source: InputSource, count: int | None) -> float | None:
    """Convert a raw count to µs or V."""
    return None if count is None else round(source.physical(count), 4)


# --- The line ---------------------------------------------------------------------------


def open_port(
    settings: ConnectionSettings,
    logged: Callable[[OpenTransport], OpenTransport] = lambda plain: plain,
) -> tuple[Transport, ConnectionSettings]:
    """Open a port or connect to a server.

    Returns the transport, and the settings that address the board. `logged` wraps the function that
    opens the port.
    """
    computer = host()
    if not is_served(settings.url):
        return logged(computer.open_transport)(settings), settings
    from trex_gui.devices.trex.cli.remote_transport import RemoteTransport  # noqa: PLC0415 - rare

    remote = RemoteTransport(settings, computer)
    opened = logged(lambda _: remote)
    return (computer.logged(opened) if computer.logged else opened)(settings), remote.settings


@contextlib.contextmanager
def open_line(settings: ConnectionSettings) -> Iterator[TrexClient]:
    """Open the line and yield its client. A StudioError becomes CommandFailed."""
    with reported_errors(), _open_client(*open_port(settings)) as client:
        yield client


@contextlib.contextmanager
def open_line_for_writing(
    settings: ConnectionSettings,
) -> Iterator[tuple[TrexClient, frozenset[int] | None]]:
    """Open the line. Also yield the baud rates that the port supports, or `None` if unknown."""
    with reported_errors():
        transport, settings = open_port(settings)
        rates = transport.rates(baud_rates())  # allowed only before the first packet
        with _open_client(transport, settings) as client:
            yield client, rates


@contextlib.contextmanager
def _open_client(transport: Transport, settings: ConnectionSettings) -> Iterator[TrexClient]:
    client = TrexClient(transport, settings)
    try:
        client.detect_echo()
        yield client
        client.drain()
    finally:
        client.close()


def identify(client: TrexClient, *, quick: bool = False) -> Signature:
    """Return the signature of the board. See `diagnose` for `quick`.

    Raises:
        NoReply, BadReply: the message contains a remedy.
    """
    try:
        try:
            return _only_board(client)
        except BadReply:
            # The echo check at the opening of the line may have missed an echo.
            client.detect_echo()
            return _only_board(client)
    except (NoReply, BadReply) as error:
        with ProgressLine("Looking for the board") as line:
            cause = diagnose(
                client,
                error,
                quick=quick,
                progress=lambda step: line(step.done, step.total, step.line.text()),
            )
        if isinstance(cause, BoardElsewhere):
            options = as_options(ConnectionSettings.on(cause.settings))
            raise NoReply(f"{cause} Use these options:\n{options}") from cause
        if isinstance(cause, TrexError) and cause.code is ErrorCode.SEVERAL_BOARDS:
            text = f"{cause} `trexcmd boards` prints the options that reach each board."
            raise BadReply(text) from cause
        raise cause from error


def _only_board(client: TrexClient) -> Signature:
    signature = read_signature(client.request, has_crc=client.has_crc)
    command = GetParameter(parameter_number(ParameterKey.DEVICE_NUMBER))
    number = read_reliably(client.request, command, has_crc=client.has_crc)
    if several_reply(client, number):
        texts = client.settings.label, client.settings.line.text()
        raise TrexBadReplyError(ErrorCode.SEVERAL_BOARDS, *texts)
    return signature


# --- Reports of list and find -----------------------------------------------------------


def _identify(url: str, options: Mapping[str, Any]) -> PortAnswer:
    settings = link_settings(options, url)
    client = TrexClient(*open_port(settings))
    try:
        client.detect_echo()
        signature = read_reliably(client.request, GetSignature(), has_crc=client.has_crc)
    except NoReply:
        return PortAnswer("echo only" if client.echo else "no reply")
    except BadReply as error:
        return PortAnswer(f"no TReX: {error}")
    finally:
        client.close()
    return PortAnswer(str(signature), signature.model.name, signature.firmware)


def _describe(board: FoundBoard) -> str:
    number = f", device number {board.device_number}" if board.device_number is not None else ""
    side = " (RS-232 side)" if board.echo else ""
    text = f"{board.signature} on {board.settings.text()}{number}{side}."
    return f"{text}\n{board.note}".rstrip()


def row_of(board: FoundBoard) -> dict[str, Any]:
    return {
        "product": board.signature.model.name,
        "firmware": board.signature.firmware,
        "detection": board.settings.line.detection.name.lower(),
        "polynomial": f"{board.settings.polynomial:02X}",
        "options": as_options(board.settings),
    }


PORT_REPORTS = PortReports(_identify, _describe, row_of)


def specs_of(name: str) -> list[ParameterSpec]:
    """Return the specs of a parameter in all firmware. Raises UsageError if there are none."""
    specs = []
    for model in device_table().models:
        for firmware in model.firmware:
            with contextlib.suppress(BadRequest):
                specs.append(parameters_of(model.key, firmware)[name])
    if not specs:
        keys = [row["key"] for row in device_table().rows]
        close = difflib.get_close_matches(name.lower(), keys, n=1)
        hint = f" Did you mean {close[0]}?" if close else ""
        raise click.UsageError(f"No TReX has a parameter {name!r}.{hint}")
    return specs
