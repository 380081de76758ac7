"""Exported programs, and simulated boards on which they run."""

import functools
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from tests.devices.trex.settings.samples import factory
from tests.support.simulator import SimulatorProcess
from trex_gui.core.code import Language
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.settings.code_export import export_code, file_name
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.simulator.memory import Eeprom

HERE = Path(__file__).parent
TIMEOUT = 50  # seconds for a program or compiler on a busy computer
REPLY_TIMEOUT = 10  # seconds; a simulator on a busy computer may pause for over one second

WARNINGS = ("-Wall", "-Wextra", "-Werror")
# The oldest standard of cores for Arduino boards.
CPP = ("g++", "-std=gnu++11", *WARNINGS, f"-I{HERE / 'arduino'}")

DEVICE = 11
POLYNOMIAL = 0x91
CHANGED = {
    "required_channels": 3,
    "serial_timeout": 120,
    "motor1_acceleration": 127,
    "motor2_acceleration": 100,
    "motor1_current_limit": 60,
    "motor_mode": 1,
}
"""Exported parameters that differ from the defaults."""

CALIBRATIONS = {
    CalibrationKey.RC_CHANNEL_2: Calibration(2511, 3661, 4999, 88),
    CalibrationKey.RC_CHANNEL_5: Calibration(127, 128, 16383, 0),
}


def link(
    *,
    expanded: bool = False,
    crc: bool = False,
    device: int = DEVICE,
    baud: int = 19200,
    stop_bits: int = 1,
) -> ConnectionSettings:
    line = LineSettings(baud, Detection.CRC7 if crc else Detection.NONE, stop_bits)
    return ConnectionSettings("unused", line, device if expanded else None, POLYNOMIAL)


def settings_for(link: ConnectionSettings, model: str = "trex", **parameters: int) -> Settings:
    """Return settings that differ from the defaults, with the line settings of the connection."""
    defaults = factory(model)
    line = {
        "device_number": DEVICE if link.device_number is None else link.device_number,
        "crc7_polynomial": link.polynomial & 0x7F,
        "uart_settings": link.line.to_wire(),
    }
    rc = {
        key: calibration
        for key, calibration in defaults.calibrations.items()
        if key.source is InputSource.RC
    }
    return replace(
        defaults,
        parameters={**defaults.parameters, **line, **CHANGED, **parameters},
        calibrations=rc | CALIBRATIONS,
    )


class Board(SimulatorProcess):
    """Simulated board that several tests reuse."""

    def __init__(self, memory: Path, *arguments: str) -> None:
        super().__init__(*arguments, "--eeprom", str(memory))
        self._memory = memory
        self._writes_before = 0

    def reset(self, link: ConnectionSettings) -> None:
        """Reset everything but the line settings."""
        number = DEVICE if link.device_number is None else link.device_number
        self.do("line mute off", "fault 1 off", "fault 2 off", "current 1 auto", "current 2 auto")
        self.do("factory", f"eeprom uart_settings {link.line.to_wire()}")
        self.do(f"eeprom crc7_polynomial {link.polynomial & 0x7F}")
        self.do(f"eeprom device_number {number}", "power cycle")
        self._writes_before += self.writes

    @property
    def writes(self) -> int:
        """Number of writes to the memory since the last reset."""
        writes: int = self.show()["counters"]["eeprom_writes"]
        return writes - self._writes_before

    @property
    def errors(self) -> int:
        errors: int = self.show()["counters"]["uart_errors"]
        return errors

    @property
    def motors(self) -> tuple[int, int]:
        """Signed speeds of the motors. A braking motor has 0."""
        signs = {"forward": 1, "reverse": -1, "brake": 0}
        first, second = (
            signs[motor["direction"]] * motor["speed"] for motor in self.show()["motors"]
        )
        return first, second

    @property
    def braking(self) -> tuple[int, int]:
        """Braking duty of each motor, or -1 for a motor that does not brake."""
        first, second = (
            motor["speed"] if motor["direction"] == "brake" else -1
            for motor in self.show()["motors"]
        )
        return first, second

    def has(self, settings: Settings) -> bool:
        """Return whether the board has stored all these settings."""
        stored = self.show()["parameters"]
        memory = Eeprom.open(self._memory, settings.product.key)
        return all(stored[key] == wire for key, wire in settings.parameters.items()) and all(
            memory.calibration(key.source, key.channel) == calibration
            for key, calibration in settings.calibrations.items()
        )


class Boards:
    """Boards that tests share, because a simulator takes a third of a second to start."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._boards: dict[tuple[str, ...], Board] = {}

    def board(self, link: ConnectionSettings, model: str = "trex", *arguments: str) -> Board:
        """Return a board with default values and these line settings."""
        key = ("--model", model, *(arguments or ("--unpaced",)))
        if key not in self._boards:
            self._boards[key] = Board(self._folder / f"{len(self._boards)}.json", *key)
        self._boards[key].reset(link)
        return self._boards[key]

    def end(self) -> None:
        for board in self._boards.values():
            board.end()


@dataclass(frozen=True)
class Program:
    """Exported program with its command lines.

    Attributes:
        command: command that runs the program, without the port.
        interactive: command that runs the program by lines on standard input, without the port.
        drive: arguments after the port that let the program drive.
        interactive_options: arguments after the port of `interactive`.
    """

    command: tuple[str, ...]
    interactive: tuple[str, ...]
    drive: tuple[str, ...] = ()
    interactive_options: tuple[str, ...] = ()

    def run(self, port: str, *, drive: bool = False) -> subprocess.CompletedProcess[str]:
        """Run the program to its end. `stdout` includes the errors."""
        return subprocess.run(
            [*self.command, port, *(self.drive if drive else ())],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=TIMEOUT,
            check=False,
        )

    def start(self, port: str) -> subprocess.Popen[str]:
        """Start the program, and let it drive."""
        command = [*self.command, port, *self.drive]
        return subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


every_language = pytest.mark.parametrize("language", list(Language), ids=lambda code: code.value)


def compile_(command: Sequence[str]) -> None:
    """Run a compiler with warnings as errors. Skip the test without a compiler."""
    if shutil.which(command[0]) is None:
        pytest.skip(f"the compiler {command[0]} is not installed")
    result = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
    assert result.returncode == 0, result.stderr


def export_to_file(
    folder: Path, settings: Settings, link: ConnectionSettings, language: Language
) -> Path:
    path = folder / file_name(settings, language)
    path.write_text(export_code(settings, link, language), encoding="ascii")
    return path


def prepared_program(
    folder: Path,
    settings: Settings,
    link: ConnectionSettings,
    language: Language,
    *,
    drive: bool = False,
    timeout: int = REPLY_TIMEOUT,
) -> Program:
    """Export settings, and compile the program if necessary.

    Changes the timeout of the program in seconds. Changes an Arduino sketch that is to drive.
    """
    path = export_to_file(folder, settings, link, language)
    text, count = re.subn(
        r"(?m)^(TIMEOUT = |#define TREX_TIMEOUT_MS )1(\.0|000) ",
        rf"\g<1>{timeout}\g<2> ",
        path.read_text(encoding="ascii"),
    )
    assert count == 1
    path.write_text(text, encoding="ascii")
    options = ["-DWITH_SETTINGS"] if settings.parameters and settings.calibrations else []
    match language:
        case Language.PYTHON:
            python = (sys.executable, "-W", "error")
            interactive = (*python, str(HERE / "obey.py"), str(path))
            return Program((*python, str(path)), interactive, ("--drive",))
        case Language.ARDUINO:
            text = path.read_text(encoding="ascii")
            assert "#define TREX_DRIVE_DEMO 0 " in text
            if drive:
                text = text.replace("#define TREX_DRIVE_DEMO 0 ", "#define TREX_DRIVE_DEMO 1 ")
                path.write_text(text, encoding="ascii")
            program, core = str(folder / "program"), str(arduino_core(folder.parent))
            main = str(HERE / "arduino" / "main.cpp")
            compile_([*CPP, f'-DSKETCH="{path}"', *options, main, core, "-o", program])
            return Program((program,), (program,), interactive_options=("--obey",))


@functools.cache
def arduino_core(folder: Path) -> Path:
    """Compile the stub of the Arduino core, which all sketches share."""
    core = folder / "core.o"
    compile_([*CPP, "-c", str(HERE / "arduino" / "core.cpp"), "-o", str(core)])
    return core


class InteractiveProgram:
    """Exported program whose functions a test calls."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._process = process

    def do(self, word: str, a: int = 0, b: int = 0) -> list[str]:
        """Call a function. Return the printed lines."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(f"{word} {a} {b}\n")
        self._process.stdin.flush()
        lines: list[str] = []
        while (line := self._process.stdout.readline().strip()) != "done":
            assert line, "the program has ended"
            lines.append(line)
        return lines


@contextmanager
def interactive_program(program: Program, port: str) -> Iterator[InteractiveProgram]:
    """Start a program that executes the calls of a test."""
    command = [*program.interactive, port, *program.interactive_options]
    # The end of the block closes the input, which ends the program.
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        yield InteractiveProgram(process)
