"""Exported programs, and simulated boards for them."""

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
LANGUAGES = tuple(Language)
LANGUAGE_NAMES = [language.value for language in LANGUAGES]
SECONDS = 50
"""How long a program may take on a busy machine."""

LONG_TIMEOUT = 10
"""Seconds for which a program that is made ready here waits for an answer: a simulator may stand
still for longer than the second that a board never needs."""

WARNINGS = ("-Wall", "-Wextra", "-Werror")
# The oldest that cores for Arduino boards ask for.
CPP = ("g++", "-std=gnu++11", *WARNINGS, f"-I{HERE / 'arduino'}")

DEVICE = 11
POLYNOMIAL = 0x91
WANTED = {
    "required_channels": 3,
    "serial_timeout": 120,
    "motor1_acceleration": 127,
    "motor2_acceleration": 100,
    "motor1_current_limit": 60,
    "motor_mode": 1,
}
"""What the exported settings have other than the factory's."""

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


def settings_for(link: ConnectionSettings, model: str = "trex", **wanted: int) -> Settings:
    """Return settings with some values that are no defaults. The line does not change."""
    as_new = factory(model)
    line = {
        "device_number": DEVICE if link.device_number is None else link.device_number,
        "crc7_polynomial": link.polynomial & 0x7F,
        "uart_settings": link.line.to_wire(),
    }
    rc = {place: c for place, c in as_new.calibrations.items() if place.source is InputSource.RC}
    return replace(
        as_new,
        parameters={**as_new.parameters, **line, **WANTED, **wanted},
        calibrations=rc | CALIBRATIONS,
    )


class Board:
    """Simulated board that several tests use in turn."""

    def __init__(self, memory: Path, *arguments: str) -> None:
        self._simulator = SimulatorProcess(*arguments, "--eeprom", str(memory))
        self._memory = memory
        self._writes_before = 0
        self.url = self._simulator.url
        self.do = self._simulator.do
        self.show = self._simulator.show
        self.end = self._simulator.end

    def reset(self, link: ConnectionSettings) -> None:
        """Reset everything but the line settings."""
        self.do("line mute off")
        for motor in (1, 2):
            self.do(f"fault {motor} off")
            self.do(f"current {motor} auto")
        self.do("factory")
        self.do(f"eeprom uart_settings {link.line.to_wire()}")
        self.do(f"eeprom crc7_polynomial {link.polynomial & 0x7F}")
        number = DEVICE if link.device_number is None else link.device_number
        self.do(f"eeprom device_number {number}")
        self.do("power cycle")
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
        first, second = (signs[m["direction"]] * m["speed"] for m in self.show()["motors"])
        return first, second

    @property
    def braking(self) -> tuple[int, int]:
        """Braking duty of each motor. -1 without braking."""
        first, second = (
            m["speed"] if m["direction"] == "brake" else -1 for m in self.show()["motors"]
        )
        return first, second

    def has(self, settings: Settings) -> bool:
        """Return whether the board stores all these settings."""
        stored = self.show()["parameters"]
        memory = Eeprom.open(self._memory, settings.product.key)
        return all(stored[key] == wire for key, wire in settings.parameters.items()) and all(
            memory.calibration(key.source, key.channel) == calibration
            for key, calibration in settings.calibrations.items()
        )


class Boards:
    """Boards that tests share, because a start takes a third of a second."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._boards: dict[tuple[str, ...], Board] = {}

    def board(self, link: ConnectionSettings, model: str = "trex", *arguments: str) -> Board:
        """Return a new board with these line settings."""
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
        command: runs the program, up to the name of the port.
        drive: further arguments to drive.
        obey: runs the program by lines on standard input, up to the name of the port.
        behind: further arguments of `obey`.
    """

    command: tuple[str, ...]
    obey: tuple[str, ...]
    drive: tuple[str, ...] = ()
    behind: tuple[str, ...] = ()

    def run(self, port: str, *, drive: bool = False) -> subprocess.CompletedProcess[str]:
        """Run the program to its end. `stdout` also has the errors."""
        return subprocess.run(
            [*self.command, port, *(self.drive if drive else ())],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=SECONDS,
            check=False,
        )

    def start(self, port: str) -> subprocess.Popen[str]:
        """Start the program to drive."""
        command = [*self.command, port, *self.drive]
        return subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


def compile_(command: Sequence[str]) -> None:
    """Run a compiler with warnings as errors. Skip the test without a compiler."""
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed, which compiles exported programs")
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert done.returncode == 0, done.stderr


def exported(
    folder: Path, settings: Settings, link: ConnectionSettings, language: Language, text: str = ""
) -> Path:
    path = folder / file_name(settings, language)
    path.write_text(text or export_code(settings, link, language), encoding="ascii")
    return path


def prepared_program(
    folder: Path,
    settings: Settings,
    link: ConnectionSettings,
    language: Language,
    *,
    drive: bool = False,
    extra_time: int = LONG_TIMEOUT,
) -> Program:
    """Export settings, and compile the program if necessary.

    The text of an Arduino sketch is changed to drive. The timeout of every program is changed.
    """
    path = exported(folder, settings, link, language)
    text, number = re.subn(
        r"(?m)^(TIMEOUT = |#define TREX_TIMEOUT_MS )1(\.0|000) ",
        rf"\g<1>{extra_time}\g<2> ",
        path.read_text(encoding="ascii"),
    )
    assert number == 1
    path.write_text(text, encoding="ascii")
    some = ["-DWITH_SETTINGS"] if settings.parameters and settings.calibrations else []
    match language:
        case Language.PYTHON:
            python = (sys.executable, "-W", "error")
            obey = (*python, str(HERE / "obey.py"), str(path))
            return Program((*python, str(path)), obey, ("--drive",))
        case Language.ARDUINO:
            text = path.read_text(encoding="ascii")
            assert "#define TREX_DRIVE_DEMO 0 " in text
            if drive:
                text = text.replace("#define TREX_DRIVE_DEMO 0 ", "#define TREX_DRIVE_DEMO 1 ")
                path.write_text(text, encoding="ascii")
            program, core = str(folder / "program"), str(arduino_core(folder.parent))
            main = str(HERE / "arduino" / "main.cpp")
            compile_([*CPP, f'-DSKETCH="{path}"', *some, main, core, "-o", program])
            return Program((program,), (program,), behind=("--obey",))


@functools.cache
def arduino_core(folder: Path) -> Path:
    """Compile the part of the stub that all sketches share."""
    core = folder / "core.o"
    compile_([*CPP, "-c", str(HERE / "arduino" / "core.cpp"), "-o", str(core)])
    return core


class InteractiveProgram:
    """Exported program whose functions a test calls."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._process = process

    def do(self, word: str, a: int = 0, b: int = 0) -> list[str]:
        """Call a function and return its lines."""
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
    command = [*program.obey, port, *program.behind]
    # On leaving, its input ends, and so does it.
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        yield InteractiveProgram(process)
