"""Firmware of the board, as a generator that yields a `Request` for each wait.

Ref: CreativeMachinesLab/aracna, `aracna-embedded-code` of 25 Sep 2012.
"""

from collections import Counter
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from enum import Enum

from trex_gui.devices.aracna.simulator.servos import Register, Servo

BUFFER = 59  # maximum length of a line, with its newline; the sixtieth byte ends the string
BLINKING = 1.0  # seconds after `.h` during which the firmware reads nothing
_BLINKS = 10  # toggles of the LED while blinking; an even number leaves it off
PARSING = 0.000038  # seconds from the end of a line to its reply, observed
SPEED_PAUSE = 0.025  # seconds between writing and reading back the speeds
WRITING = 0.0005
"""Duration of a write packet in seconds.

Inferred, like `READING`, from round trips: 42 to 55 ms for `.v`, 33 to 37 ms for `.c` without
motion."""

READING = 0.00095  # duration of a read packet in seconds, with or without a reply
_BATCH = 0.05  # seconds of polls that are simulated as one pause

_ARRAY = 4  # bytes of the array that receives the characters of a field
_UNUSED = 10  # initial value of each byte of the array
_OVERFLOW = 11  # minimum length of a field that overwrites the stack
_SEPARATORS = b",\n"
_COMMANDS = {b"q", b"v", b"c", b"l"}


class State(Enum):
    OFF = "off"
    BOOTING = "booting"
    IDLE = "idle"
    ANSWERING = "answering"
    SPEEDS = "speeds"
    MOVING = "moving"


@dataclass(frozen=True, slots=True)
class Pause:
    """Wait during which the program is busy and reads nothing."""

    seconds: float


@dataclass(frozen=True, slots=True)
class Transmit:
    """Wait until the transmit buffer is free. The byte is then written into it."""

    byte: int


@dataclass(frozen=True, slots=True)
class Receive:
    """Wait for a received byte, which is sent into the generator."""


Request = Pause | Transmit | Receive
Program = Generator[Request, int, None]


class Restart(Exception):  # noqa: N818 - an event, not an error
    """The stack was overwritten, which restarts the firmware."""


class Firmware:
    """Firmware and its state. `boots` counts its starts."""

    def __init__(self, servos: Sequence[Servo], version: int, boot_loader: float) -> None:
        """`boot_loader`: seconds before `.h`."""
        self.servos = tuple(servos)
        self.version = version
        self.reports_motors = True  # False in builds before 22 Sep 2012
        self.state = State.OFF
        self.led = False
        self.boots = 0
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("lines", "cut", "commands", "ignored", "restarts"), 0)
        )
        self._boot_loader = boot_loader

    def program(self) -> Program:
        """Run from power-up. Some invalid lines restart the firmware."""
        while True:
            yield from self._boot()
            try:
                while True:
                    line = yield from self._read_line()
                    yield from self._execute(line)
            except Restart:
                self.counters["restarts"] += 1

    def _boot(self) -> Program:
        self.boots += 1
        self.state = State.BOOTING
        self.led = False
        if self._boot_loader:
            yield Pause(self._boot_loader)
        yield from self._print(".h\n")
        for _ in range(_BLINKS):
            self.led = not self.led
            yield Pause(BLINKING / _BLINKS)

    def _read_line(self) -> Generator[Request, int, bytes]:
        self.state = State.IDLE
        line = bytearray()
        while len(line) < BUFFER:
            line.append((yield Receive()))
            if line.endswith(b"\n"):
                break
        else:
            self.counters["cut"] += 1
        self.counters["lines"] += 1
        return bytes(line)

    def _execute(self, line: bytes) -> Program:
        """Execute a line. The second character is the name of the command."""
        self.state = State.ANSWERING
        self.counters["commands" if line[1:2] in _COMMANDS else "ignored"] += 1
        yield Pause(PARSING)
        match line[1:2]:
            case b"q":
                motors = f",{len(self.servos)}" if self.reports_motors else ""
                yield from self._print(f".q{self.version}{motors}\n")
            case b"v":
                yield from self._set_speeds(_values(line, len(self.servos)))
            case b"c":
                yield from self._move(_values(line, len(self.servos)))
            case b"l":
                self.led = {b"0": False, b"1": True}.get(line[2:3], self.led)
                yield from self._print(f".l{self.led:d}\n")

    def _set_speeds(self, speeds: Sequence[int]) -> Program:
        self.state = State.SPEEDS
        for servo, speed in zip(self.servos, speeds, strict=True):
            yield Pause(WRITING)
            servo.write_speed(speed)
        yield Pause(SPEED_PAUSE)
        yield from self._print(".v")
        for index, servo in enumerate(self.servos):
            yield Pause(READING)
            yield from self._print_value(servo.read(Register.SPEED), index)

    def _move(self, goals: Sequence[int]) -> Program:
        self.state = State.MOVING
        for servo, goal in zip(self.servos, goals, strict=True):
            yield Pause(WRITING)
            servo.write_goal(goal)
        yield from self._print(".c")
        for index, servo in enumerate(self.servos):
            yield from self._await(servo)
            yield Pause(READING)
            yield from self._print_value(servo.read(Register.POSITION), index)

    @staticmethod
    def _await(servo: Servo) -> Program:
        """Poll a servo's moving flag until it is 0. Without a reply, the flag reads as -1."""
        while True:
            yield Pause(READING)
            if servo.read(Register.MOVING) == 0:
                return
            seconds = min(servo.remaining if servo.answers else _BATCH, _BATCH)
            polls = int(seconds / READING) - 1
            if polls > 0:
                yield Pause(polls * READING)

    def _print_value(self, value: int, index: int) -> Program:
        is_last = index == len(self.servos) - 1
        yield from self._print(f"{value}\n" if is_last else f"{value},")

    def _print(self, text: str) -> Program:
        for byte in text.replace("\n", "\r\n").encode("ascii"):
            yield Transmit(byte)


def _values(line: bytes, motors: int) -> list[int]:
    """Return the value of each motor, 0-65535.

    The firmware does not check for the end of the line. It reads until it has found a comma or
    newline for each motor, and collects characters in an array of four bytes without a bounds
    check. Characters after the last value are ignored. The servos ignore invalid values.

    Raises:
        Restart: a value is missing, or a field has eleven or more characters. With ten characters,
            the original firmware replies only half of the time. The simulator always replies.
    """
    fields: list[bytes] = []
    start = 2
    for index in range(start, len(line)):
        if len(fields) < motors and line[index] in _SEPARATORS:
            fields.append(line[start:index])
            start = index + 1
    if len(fields) < motors or any(len(field) >= _OVERFLOW for field in fields):
        raise Restart
    return [_number(field) for field in fields]


def _number(field: bytes) -> int:
    """Convert a field as the firmware does.

    Inferred from known values: an empty field is 10, `abc` is 49, `0x1F` is 721 and `1e3` is 633. A
    field with a sign or a point is above 1023. The array initially contains four tens. Each
    character is stored as its difference from "0" in eight bits. Trailing non-digits count as
    unused. The result has sixteen bits.
    """
    digits = [(byte - ord("0")) & 0xFF for byte in field[:_ARRAY]]
    digits += [_UNUSED] * (_ARRAY - len(digits))
    while len(digits) > 1 and digits[-1] > 9:
        digits.pop()
    number = 0
    for digit in digits:
        number = number * 10 + digit
    return number & 0xFFFF
