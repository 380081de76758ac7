"""Options that commands of every device share."""

from typing import TYPE_CHECKING

import click

from trex_gui.core.cli.console import UsageError

if TYPE_CHECKING:
    from collections.abc import Sequence


def hexadecimal(text: str) -> int:
    """Read a hexadecimal number.

    Raises:
        UsageError: it is none.
    """
    try:
        return int(text, 16)
    except ValueError:
        raise UsageError(f"{text!r} is not a hexadecimal number such as 89.") from None


def required_port(port: str | None) -> str:
    """Return the URL given with `--port`.

    Raises:
        UsageError: none was given.
    """
    if not port:
        raise UsageError("Which port? Give --port, or set TREX_PORT; `trexcmd list` shows them.")
    return port


def _complete_port(
    _ctx: click.Context, _param: click.Parameter, incomplete: str
) -> "Sequence[str]":
    from serial.tools import list_ports  # noqa: PLC0415 - takes as long as the rest together

    ports = sorted(port.device for port in list_ports.comports())
    return [port for port in ports if port.startswith(incomplete)]


port_option = click.option(
    "--port",
    envvar="TREX_PORT",
    metavar="URL",
    shell_complete=_complete_port,
    help="Port of the device, such as /dev/ttyUSB0, COM3, socket://host:port or "
    "rfc2217://host:port. Default: environment variable TREX_PORT.",
)
timeout_option = click.option(
    "--timeout",
    "extra_timeout",
    type=click.FloatRange(0),
    default=0.0,
    metavar="S",
    help="Seconds added to the deadline of every reply.",
)
json_option = click.option("--json", "as_json", is_flag=True, help="JSON instead of text.")
