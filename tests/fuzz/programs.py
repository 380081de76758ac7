"""Fuzzing of command lines, of the configuration and of files opened in the window."""

import contextlib
import io
import os
import signal
from collections.abc import Iterator, Sequence
from pathlib import Path
from random import Random
from unittest.mock import patch

import click
from click.testing import CliRunner, Result
from PySide6.QtCore import QCoreApplication, QSettings
from PySide6.QtWidgets import QApplication

from tests.fuzz.files import YAML, pose_samples, recording_samples, settings_samples
from tests.fuzz.fuzzing import InputFactory, Target, mutations
from tests.support.program import aracna, trex
from tests.support.virtual_command import VirtualCommand
from tests.support.virtual_devices import VirtualProcess, VirtualSimulator
from tests.support.virtual_time import VirtualRuntime, deliver
from trex_gui import app
from trex_gui.cli import simulator
from trex_gui.cli.program import main
from trex_gui.composition import build
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.resource_files import resource
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, EditFiles
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import use_runtime
from trex_gui.ui.theme.theme import theme

EXIT_CODES = {0, 1, 2}
URL, ROBOT_URL = "virtual:board", "virtual:robot"


class VirtualComputer(VirtualRuntime):
    """Computer in virtual time, with simulated ports only."""

    def open_transport(self, settings: PortSettings) -> Transport:
        if settings.url not in self.ports:
            raise PortUnavailable(f"There is no port {settings.url}.")
        return super().open_transport(settings)


@contextlib.contextmanager
def _computer(folder: Path) -> Iterator[VirtualComputer]:
    """Change to a folder, and connect simulated devices to `URL` and `ROBOT_URL`."""
    computer = VirtualComputer()
    computer.create_process = lambda parent: VirtualProcess(computer, parent)
    before = use_runtime(computer)
    devices = [
        VirtualSimulator(computer, URL, "--unpaced"),
        VirtualSimulator(computer, ROBOT_URL, "--aracna", "--unpaced"),
    ]
    with contextlib.chdir(folder), patch.dict(os.environ, TREX_STUDIO_DATA=str(folder / "data")):
        try:
            yield computer
        finally:
            for device in devices:
                device.end()
            use_runtime(before)
    assert computer.is_idle, "a thread still runs"


# --- Arguments --------------------------------------------------------------------------


def _arguments(data: bytes) -> list[str]:
    """Return an argument for each line. All paths are in the working folder."""
    text = data.decode("utf-8", "surrogateescape").replace("\0", "").replace("/", "_")
    return text.split("\n")[:20]


def _check_result(result: Result, words: Sequence[str]) -> None:
    assert result.exit_code in EXIT_CODES, f"{words} ended with {result.exit_code}"
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    assert "Traceback" not in result.stderr
    assert result.exit_code == 0 or result.stderr.strip(), f"{words} failed without a message"


def check_trexcmd(data: bytes, folder: Path) -> None:
    words = _arguments(data)
    _create_files(folder)
    environment: dict[str, str | None] = {"TREX_PORT": URL}
    with _computer(folder) as computer:
        command = VirtualCommand(computer, words, environment, stdin="product: TReX\n")
        for _ in range(4):
            if computer.run_until(lambda: command.returncode is not None, 20):
                break
            command.send_signal(signal.SIGINT)
        command.wait(60)
    _check_result(command.result, words)


def _create_files(folder: Path) -> None:
    settings = (resource("samples") / "trex_factory_defaults.txt").read_bytes()
    snapshots = folder / "data" / "snapshots"
    snapshots.mkdir(parents=True)
    for path in (folder / "settings.txt", snapshots / "20260102T030405Z-trex-1.2.txt"):
        path.write_bytes(settings)
    (folder / "poses.ppr").write_bytes(resource("aracna/sample.ppr").read_bytes())


def check_trex_sim(data: bytes, folder: Path) -> None:
    """Check the steps before the simulator opens its port."""
    words = _arguments(data)
    with (
        contextlib.chdir(folder),
        patch.object(simulator, "Server"),
        patch.object(simulator, "_endpoint"),
    ):
        assert isinstance(simulator.main, click.Command)
        result = CliRunner().invoke(simulator.main, words)
    _check_result(result, words)


def check_trex_gui(data: bytes, folder: Path) -> None:
    """Check the arguments, and open the window with valid arguments."""
    words = _arguments(data)
    output, code = io.StringIO(), None
    try:
        with contextlib.redirect_stderr(output), contextlib.redirect_stdout(output):
            arguments = app._arguments(words)
    except SystemExit as error:
        code = error.code
    if code is not None:
        assert code in EXIT_CODES
        assert output.getvalue().strip()
        return
    with _window(folder) as (program, computer):
        if arguments.port:
            program.connect_to_port(arguments.port, arguments.device)
        if arguments.settings is not None:
            program.open_file(arguments.settings, connecting=bool(arguments.port))
        computer.advance(3.0)


VALUES = (
    *("1", "-1", "7", "50", "aux", "rc", "settings.txt", "out.txt", "-", "--", "any.ppr", "81"),
    *("86 1F", "FF" * 300, "1e9", "nan", "inf", "0x7f", "", " ", "\udcff", "\u00bd"),
    *("\u0663", "9" * 5000),
    *("%s", "{0}", "\r", "\x1b[31m", "[::1]:x", "..", "~", "7:trexjr", "127.0.0.1:0", "HOST:99999"),
    *("1500us", "2.5V", "0.5", URL, ROBOT_URL, "virtual:none"),
    *(spec.key for spec in parameters_of("trex", "1.2")),
)


_NETWORK = {"robots", "serve"}  # commands that wait for other computers, in real time


def _command_lines(*programs: click.Command) -> InputFactory:
    """Return a function that creates mostly valid arguments of these programs."""

    def create(random: Random) -> bytes:
        words, command = [], random.choice(programs)
        while isinstance(command, click.Group):
            context = click.Context(command)
            words.append(random.choice(sorted({*command.list_commands(context)} - _NETWORK)))
            subcommand = command.get_command(context, words[-1])
            assert subcommand is not None
            command = subcommand
        parts = [_argument(random, parameter) for parameter in command.params]
        random.shuffle(parts)
        words += [word for part in parts for word in part]
        if random.random() < 0.1:
            words.insert(random.randrange(len(words) + 1), random.choice(VALUES))
        return "\n".join(words).encode("utf-8", "surrogateescape")

    return create


VALID_VALUES = {
    "port": (URL, URL, ROBOT_URL),
    "baud": ("19200",),
    "polynomial": ("89",),
    "extra_timeout": ("0.1",),
    "seconds": ("0.2",),
    "name": ("serial_timeout", "device_number", "uart_settings", "0x7f", "centre"),
    "value": ("5", "0.5 s", "19200 baud"),
    "file": ("settings.txt", "poses.ppr", "out.txt", "-"),
    "first": ("settings.txt", "1"),
    "second": ("settings.txt", "1"),
    "out": ("out.txt", "-"),
    "packet": ("81", "861F", "8081", "AF 07 05 55 2A"),
    "values": ("300",),
    "speed": ("50", "-20", "0"),
    "channel": ("1",),
    "devices": ("7", "9:trexjr"),
    "tcp": ("127.0.0.1:0",),
    "rfc2217": ("[::1]:0",),
}
"""Valid values by name of the parameter. Other parameters are numbers."""


def _argument(random: Random, parameter: click.Parameter) -> list[str]:
    if not parameter.required and random.random() < 0.8:
        return []
    if random.random() < 0.1:
        return [random.choice(VALUES)]
    choices: Sequence[str] = VALID_VALUES.get(parameter.name or "", ("1", "2", "3"))
    if isinstance(parameter.type, click.Choice):
        choices = [str(choice) for choice in parameter.type.choices]
    values = [random.choice(VALUES if random.random() < 0.05 else choices)]
    if isinstance(parameter, click.Option):
        return [random.choice(parameter.opts), *([] if parameter.is_flag else values)]
    return values


def _trex_gui_samples() -> Sequence[bytes]:
    return [
        command.replace(" ", "\n").encode()
        for command in (
            "--port virtual:none --device aracna --timeout 0.5",
            f"--port {URL} --settings any.txt",
            "--settings any.ppr",
            "--demo --tour pictures",
        )
    ]


# --- Configuration ----------------------------------------------------------------------


@contextlib.contextmanager
def _window(folder: Path) -> Iterator[tuple[Program, VirtualComputer]]:
    """Open the window of a program whose configuration is in a folder."""
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder))
    with _computer(folder) as computer:
        program = build()
        try:
            program.window.show()
            computer.advance(0.5)
            yield program, computer
        finally:
            program.window.close()
            computer.advance(2.0)
            assert program.close(), "a thread still runs"
            deliver()
            theme().set_scheme("system")
            theme().set_font_size(100)


CONFIGURATION_KEYS = (
    *("window/geometry", "window/state", "window/scheme", "window/font_size", "window/device"),
    *("files/recent", "trex/page", "aracna/page", "demo_panel/wanted", "aracna/demo_panel"),
    *("ports/typed", "ports/known", "line/settings", "line/device_number", "line/polynomial"),
    *("line/reserved", "boards/virtual%3Aboard", "motors/ceilings/trex-1.2-7", "motors/brake"),
    *("motors/lockout", "motors/return_to_zero", "motors/stop_on_leaving"),
    *("gamepad/stops_unfocused", "aracna/limits", "transcript/polling", "aracnaTranscript/polling"),
    *("currents/window", "currents/top", "currents/shown", "currents/colors"),
    *("currents/plot_splitter", "currents/figures_splitter", "export/light_background"),
    *("recording/keep_events", "recording/with_run", "parameters/both_motors", "units/own_first"),
)
"""Keys that the window reads until it is connected to the board at `URL`."""

INVALID_VALUES = (
    *("99999999999999999999", "-1", "1, 2, 3", "@Invalid()", "@Size(1 2)", "nan", "1e999", "@", ""),
    *("true, false", "@ByteArray(abc)", "@Rect(1 2 3 4)", "\\x0", "9" * 5000, "@DateTime(\\0\\0)"),
    *("@Variant(\\0\\0\\0\\x4\\0)", "@Variant(\\0\\0\\0\\x7f\\0\\0\\0\\xePyObject\\0)"),
    *("\\xd800", "trex \x1b", "a\\nb"),
)


def _configuration(values: dict[str, str]) -> bytes:
    groups: dict[str, list[str]] = {}
    for key, value in values.items():
        group, _, name = key.rpartition("/")
        groups.setdefault(group or "General", []).append(f"{name}={value}\n")
    return "".join(f"[{group}]\n{''.join(lines)}" for group, lines in groups.items()).encode()


def _configurations() -> Sequence[bytes]:
    """Return configurations that together have each invalid value at each key."""
    rotated = [
        {
            key: INVALID_VALUES[(place + shift) % len(INVALID_VALUES)]
            for place, key in enumerate(CONFIGURATION_KEYS)
        }
        for shift in range(len(INVALID_VALUES))
    ]
    return list(map(_configuration, rotated))


def check_configuration(data: bytes, folder: Path) -> None:
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder))
    path = Path(
        QSettings(
            QCoreApplication.organizationName(), QCoreApplication.applicationName()
        ).fileName()
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    with _window(folder) as (program, computer):
        assert program.window.isVisible()
        for workspace in program.workspaces.values():
            for number in range(workspace.page_count):
                workspace.show_page_at(number)
        program.create_plots()
        assert program.window.size().width() < 100_000
        program.connect_to_port(URL, "trex")
        computer.advance(2.0)


GUI_WORDS = (b"--port", b"--device", b"--settings", b"--timeout", b"--demo", b"--tour", b"--x")
INI = (*(value.encode() for value in INVALID_VALUES), b'"', b"[", b"]", b"=", b"%", b"\\x")
assert isinstance(simulator.main, click.Command)


def check_opened_file(data: bytes, folder: Path) -> None:
    """Open a file of any kind in the window."""
    is_recording = data[:6] == b"SQLite"
    path = folder / f"any{'.trexrec' if is_recording else '.ppr' if b'Pose=' in data else '.txt'}"
    path.write_bytes(data)
    with _window(folder) as (program, computer):
        if is_recording:
            for device in (trex(program), aracna(program)):
                device.workspace.recordings.open_file(path)
        else:
            program.open_file(path, connecting=False)
        computer.advance(2.0)
        for window in QApplication.topLevelWidgets():
            window.grab()
            window.close()


# --- Pending edits ----------------------------------------------------------------------


def check_pending_edits(data: bytes, folder: Path) -> None:
    """Connect a board that has a file of pending edits."""
    with _computer(folder) as computer:
        settings = factory_settings(device_table().model("trex"), "1.2")
        path = EditFiles().path(BoardIdentity.of(settings))
        path.parent.mkdir(parents=True)
        path.write_bytes(data)
        device = Device()
        try:
            device.connect_to(ConnectionSettings(URL))
            assert computer.run_until(lambda: device.edit_backup._is_read, 10)
            before = dict(device.parameters.values.all_stored)
            device.edit_backup.restore()
            computer.advance(1.0)
            assert device.parameters.values.all_stored == before
            device.draft.discard_edits()
        finally:
            computer.run_until(device.shut_down, 10)


# --- Targets ----------------------------------------------------------------------------

RUN = 10_000  # bytes that harness and Qt retain after a run, which are freed with the process
OUTPUT = 100_000  # bytes of captured output that click retains

PROGRAM_TARGETS = (
    Target("trexcmd", _command_lines(main), check_trexcmd, examples=15, growth=OUTPUT),
    Target(
        "pending_edits",
        mutations(settings_samples, YAML),
        check_pending_edits,
        examples=6,
        growth=RUN,
    ),
    Target("trex_sim", _command_lines(simulator.main), check_trex_sim, examples=20, growth=OUTPUT),
    Target(
        "trex_gui",
        mutations(_trex_gui_samples, [*GUI_WORDS, *map(os.fsencode, VALUES)]),
        check_trex_gui,
        examples=6,
        growth=RUN,
    ),
    Target(
        "opened_files",
        mutations(lambda: [*settings_samples(), *pose_samples(), *recording_samples()], YAML),
        check_opened_file,
        examples=2,
        growth=RUN,
    ),
    Target(
        "configuration",
        mutations(_configurations, INI),
        check_configuration,
        examples=1,
        growth=RUN,
    ),
)
