"""Exported programs made ready to run, and simulated boards for them."""

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
    """Return how a board is reached."""
    line = LineSettings(baud, Detection.CRC7 if crc else Detection.NONE, stop_bits)
    return ConnectionSettings("unused", line, device if expanded else None, POLYNOMIAL)


def settings_for(link: ConnectionSettings, model: str = "trex", **wanted: int) -> Settings:
    """Return settings that leave the line as it is, with some values that no factory sets."""
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
    """A simulated board, lent to one test after the other."""

    def __init__(self, memory: Path, *arguments: str) -> None:
        self._simulator = SimulatorProcess(*arguments, "--eeprom", str(memory))
        self._memory = memory
        self._writes_before = 0
        self.url = self._simulator.url
        self.do = self._simulator.do
        self.show = self._simulator.show
        self.end = self._simulator.end

    def make_new(self, link: ConnectionSettings) -> None:
        """Make it as good as new, but for its line."""
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
        """How often the memory was written to."""
        writes: int = self.show()["counters"]["eeprom_writes"]
        return writes - self._writes_before

    @property
    def errors(self) -> int:
        """How many errors there were on the line."""
        errors: int = self.show()["counters"]["uart_errors"]
        return errors

    @property
    def motors(self) -> tuple[int, int]:
        """How fast the motors run, with signs; a braked one counts as 0."""
        signs = {"forward": 1, "reverse": -1, "brake": 0}
        first, second = (signs[m["direction"]] * m["speed"] for m in self.show()["motors"])
        return first, second

    @property
    def braking(self) -> tuple[int, int]:
        """With what strength each motor brakes; -1 for one that does not."""
        first, second = (
            m["speed"] if m["direction"] == "brake" else -1 for m in self.show()["motors"]
        )
        return first, second

    def has(self, settings: Settings) -> bool:
        """Whether it stores what the settings hold, all of it."""
        stored = self.show()["parameters"]
        memory = Eeprom.open(self._memory, settings.product.key)
        return all(stored[key] == wire for key, wire in settings.parameters.items()) and all(
            memory.calibration(key.source, key.channel) == calibration
            for key, calibration in settings.calibrations.items()
        )


class Boards:
    """Starting a board takes a third of a second; these go from test to test."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._boards: dict[tuple[str, ...], Board] = {}

    def board(self, link: ConnectionSettings, model: str = "trex", *arguments: str) -> Board:
        """Return a board that is reached in this way and is new otherwise."""
        key = ("--model", model, *(arguments or ("--unpaced",)))
        if key not in self._boards:
            self._boards[key] = Board(self._folder / f"{len(self._boards)}.json", *key)
        self._boards[key].make_new(link)
        return self._boards[key]

    def end(self) -> None:
        """End them all."""
        for board in self._boards.values():
            board.end()


@dataclass(frozen=True)
class Program:
    """An exported program, ready to run.

    Attributes:
        command: runs it as a person would, up to the name of the port.
        drive: what makes it drive, behind the port.
        obey: runs it by lines on standard input, up to the name of the port.
        behind: what obeying needs behind the port.
    """

    command: tuple[str, ...]
    obey: tuple[str, ...]
    drive: tuple[str, ...] = ()
    behind: tuple[str, ...] = ()

    def run(self, port: str, *, drive: bool = False) -> subprocess.CompletedProcess[str]:
        """Run it to its end; what it says is in `stdout`, messages of errors too."""
        return subprocess.run(
            [*self.command, port, *(self.drive if drive else ())],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=SECONDS,
            check=False,
        )

    def start(self, port: str) -> subprocess.Popen[str]:
        """Start it, to drive."""
        command = [*self.command, port, *self.drive]
        return subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


def compile_(command: Sequence[str]) -> None:
    """Run a compiler, whose warnings are errors; the test is skipped where there is none."""
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed, which compiles exported programs")
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert done.returncode == 0, done.stderr


def exported(
    folder: Path, settings: Settings, link: ConnectionSettings, language: Language, text: str = ""
) -> Path:
    """Export settings into a folder and return the file."""
    path = folder / file_name(settings, language)
    path.write_text(text or export_code(settings, link, language), encoding="ascii")
    return path


def made_ready(
    folder: Path,
    settings: Settings,
    link: ConnectionSettings,
    language: Language,
    *,
    drive: bool = False,
    extra_time: int = LONG_TIMEOUT,
) -> Program:
    """Export settings, compile them where the language wants that, and say how to run them.

    An Arduino sketch drives because its text is changed, as a person would do it; so is the time
    for which any program waits for an answer.
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
    """Return the part of the stub that is the same for every sketch, compiled."""
    core = folder / "core.o"
    compile_([*CPP, "-c", str(HERE / "arduino" / "core.cpp"), "-o", str(core)])
    return core


class Obedient:
    """An exported program whose functions a test calls, one after the other."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._process = process

    def do(self, word: str, a: int = 0, b: int = 0) -> list[str]:
        """Call a function; return the lines that it wrote."""
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
def obedient(program: Program, port: str) -> Iterator[Obedient]:
    """Start a program that does what a test says, until the test has no more to say."""
    command = [*program.obey, port, *program.behind]
    # On leaving, its input ends, and so does it.
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        yield Obedient(process)
