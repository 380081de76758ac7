"""Messages, errors, progress and options that all command-line programs share."""

import contextlib
import json
import re
import shlex
import shutil
import signal
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from types import FrameType
from typing import Any, Self, TypeVar

import click

from trex_gui.core.command_io import FileName
from trex_gui.core.decimals import decimal
from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.host import OpenTransport, host
from trex_gui.core.plugin import Lazy
from trex_gui.core.signals import ENDING, FROM_TERMINAL, SUSPENDING, handled_signals
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic import Decoder, logged
from trex_gui.core.transport.transcript import TranscriptWriter
from trex_gui.core.transport.urls import url_problem

FunctionT = TypeVar("FunctionT", bound=Callable[..., Any])


class CommandFailed(click.ClickException):
    """Failure of a device, a line or a file. Exit code: 1, or see `FAILURE_EXIT_CODE`."""

    def __init__(self, message: object) -> None:
        super().__init__(str(message))


def say(message: object) -> None:
    click.echo(str(message), err=True)


def shell_words(*words: str) -> str:
    """Quote words for the shell. Windows shells support only double quotes."""
    quoted = (f'"{word}"' if re.search(r"[^\w.:/\\-]", word) else word for word in words)
    return " ".join(quoted) if sys.platform == "win32" else shlex.join(words)


def print_json(value: object) -> None:
    click.echo(json.dumps(value, indent=2, ensure_ascii=False))


@contextlib.contextmanager
def reported_errors() -> Iterator[None]:
    """Convert a StudioError to CommandFailed."""
    try:
        yield
    except StudioError as error:
        raise CommandFailed(error) from error


class ProgressLine:
    """Progress on one terminal line. Prints nothing if stderr is not a terminal."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._shown_width = 0
        self._stream = getattr(sys.stderr, "below", sys.stderr)

    def __call__(self, done: int, total: int, step: str) -> None:
        if not self._stream.isatty():
            return
        width = 20
        filled = width * done // max(total, 1)
        text = f"{self._title} [{'#' * filled}{'.' * (width - filled)}] {done}/{total} {step}"
        text = text[: shutil.get_terminal_size().columns - 1]  # a wrapped line cannot be cleared
        click.echo("\r" + text.ljust(self._shown_width), file=self._stream, nl=False)
        self._shown_width = len(text)

    def clear(self) -> None:
        if self._shown_width:
            click.echo("\r" + " " * self._shown_width + "\r", file=self._stream, nl=False)
            self._shown_width = 0

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.clear()


class Interruption:
    """Records requests to end the program (Ctrl-C, SIGTERM, a closed terminal).

    The command checks for a request between two transactions. A second request ends the program
    at once, unless `must_finish` is true. A command that must finish is never suspended: Ctrl-Z
    requests its end, and terminal access from the background does not suspend it. Signals that were
    ignored when the program started (`nohup`) stay ignored.
    """

    def __init__(self, *, must_finish: bool = False) -> None:
        self._must_finish = must_finish
        self._interrupted = False
        self._previous: dict[int, Any] = {}

    def __bool__(self) -> bool:
        return self._interrupted

    def __enter__(self) -> Self:
        for number in handled_signals((*ENDING, *((SUSPENDING,) if self._must_finish else ()))):
            self._previous[number] = signal.signal(number, self._record)
        for number in handled_signals(FROM_TERMINAL if self._must_finish else ()):
            self._previous[number] = signal.signal(number, signal.SIG_IGN)
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._previous.items():
            signal.signal(number, handler)

    def _record(self, number: int, frame: FrameType | None) -> None:
        del number, frame
        if self._interrupted and not self._must_finish:
            raise KeyboardInterrupt
        self._interrupted = True


def hexadecimal(text: str) -> int:
    """Parse a hexadecimal number. Raises UsageError."""
    try:
        return int(text, 16)
    except ValueError:
        raise click.UsageError(f"{text!r} is not a hexadecimal number such as 89.") from None


class FiniteRange(click.FloatRange):
    """Range of finite numbers, parsed by `decimal`."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        try:
            parsed = decimal(value) if isinstance(value, str) else value
        except BadRequest as error:
            self.fail(f"{error}.", param, ctx)
        number: float = super().convert(parsed, param, ctx)
        return number


def required_port(port: str | None) -> str:
    """Return the URL of `--port`. Raises UsageError if it is missing."""
    if not port:
        raise click.UsageError(
            "No port is given. Pass --port or set TREX_PORT. `trexcmd list` shows the ports."
        )
    return port


def _complete_port(_ctx: click.Context, _param: click.Parameter, incomplete: str) -> Sequence[str]:
    from serial.tools import list_ports  # noqa: PLC0415 - slow import

    ports = (port.device for port in list_ports.comports())
    return sorted(port for port in ports if port.startswith(incomplete))


def _check_port(_context: click.Context, _option: click.Parameter, port: str | None) -> str | None:
    if port and (problem := url_problem(port)):
        raise click.BadParameter(problem)
    return port


port_option = click.option(
    "--port",
    envvar="TREX_PORT",
    callback=_check_port,
    metavar="URL",
    shell_complete=_complete_port,
    help="Port of the device, such as /dev/ttyUSB0, COM3, socket://host:port or "
    "rfc2217://host:port. Default: environment variable TREX_PORT.",
)
timeout_option = click.option(
    "--timeout",
    "extra_timeout",
    type=FiniteRange(0),
    default=0.0,
    metavar="S",
    help="Seconds added to the deadline of every reply.",
)
seconds_option = click.option(
    "--seconds",
    type=FiniteRange(0, min_open=True),
    metavar="S",
    help="Duration in seconds. Default: until Ctrl-C.",
)
json_option = click.option("--json", "as_json", is_flag=True, help="Print JSON instead of text.")


def all_options(*options: Callable[[FunctionT], FunctionT]) -> Callable[[FunctionT], FunctionT]:
    def add(function: FunctionT) -> FunctionT:
        for option in reversed(options):
            function = option(function)
        return function

    return add


def traffic_option(
    decoder: "Lazy[type[Decoder]]", *, is_search: bool = False
) -> Callable[[FunctionT], FunctionT]:
    """Return an option that writes the traffic of a command to a file.

    `is_search`: the command searches for devices.
    """

    def start(context: click.Context, _option: click.Parameter, file: str | None) -> None:
        if file is None or context.resilient_parsing:
            return
        current = host()
        epoch = time.time() - current.clock()
        writer = TranscriptWriter(Path(file), decoder.load()(), epoch, is_search=is_search)

        def open_logged(open_transport: OpenTransport) -> OpenTransport:
            def open_and_log(settings: PortSettings) -> Transport:
                writer.open()
                return logged(writer.record, open_transport, current.clock)(settings)

            return open_and_log

        def finish() -> None:
            writer.close()
            if writer.error is not None:
                say(f"{file} is incomplete: {writer.error.strerror or writer.error}.")

        open_transport = open_logged(current.open_transport)
        context.obj = replace(current, open_transport=open_transport, logged=open_logged)
        context.call_on_close(finish)

    return click.option(
        "--traffic",
        type=FileName(dir_okay=False),
        metavar="FILE",
        expose_value=False,
        callback=start,
        help="Write all bytes on the line and their meaning to FILE, like the Traffic page.",
    )
