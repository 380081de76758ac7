"""The board's program, written as it runs: one thread of doing that waits where the chip waits.

Ref: CreativeMachinesLab/aracna, `aracna-embedded-code` of 25 Sep 2012, as it is described. It
knows no clock: it yields what it waits for, and goes on when that is over.
"""

import math
from collections import Counter
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from enum import Enum

from trex_gui.devices.aracna.simulator import parsing
from trex_gui.devices.aracna.simulator.servos import Register, Servo

BUFFER = 59
"""Characters that one line may have, newline included; the sixtieth byte ends the string."""

BLINKING = 1.0
"""Seconds of blinking after `.h` in which nothing is read."""

_BLINKS = 10
"""Switchings of the LED in that time; an even number leaves it off."""

SPEED_PAUSE = 0.025
"""Seconds between writing the speeds and reading them back."""

WRITING = 0.000125
"""Seconds for a packet that sets something; with `READING` inferred from the round trips:
42 to 55 ms for `.v`, 33 to 37 ms for `.c` without motion."""

READING = 0.000875
"""Seconds for a packet that asks something, with its answer or without."""

_LUMP = 0.05
"""Seconds of polls that are taken together when none of them can be the last one."""


class State(Enum):
    """What the firmware is at."""

    OFF = "off"
    BOOTING = "booting"
    IDLE = "idle"
    ANSWERING = "answering"
    SPEEDS = "speeds"
    MOVING = "moving"
    HUNG = "hung"


@dataclass(frozen=True, slots=True)
class Pause:
    """The program is busy for so many seconds and reads nothing."""

    seconds: float


@dataclass(frozen=True, slots=True)
class Transmit:
    """The program gives a byte to the host and waits until it is out."""

    byte: int


@dataclass(frozen=True, slots=True)
class Receive:
    """The program waits for a byte of the host, which is sent into it."""


Wish = Pause | Transmit | Receive
Program = Generator[Wish, int, None]
_Part = Generator[Wish, int, None]


class Firmware:
    """What the program remembers, and the program.

    Attributes:
        servos: on the bus, motor 0 first.
        version: what `.q` says.
        tells_motors: whether `.q` says how many motors there are; builds from before
            22 Sep 2012 do not.
        state: what it is at.
        led: whether the debug LED is on.
        boots: how often it has started.
        counters: lines read, commands obeyed, lines ignored, restarts of its own, hangs.
    """

    def __init__(
        self,
        servos: Sequence[Servo],
        version: int = 1,
        *,
        tells_motors: bool = True,
        boot_loader: float = 0.0,
    ) -> None:
        """Take the servos that hang on the bus.

        Args:
            servos: motor 0 first.
            version: what `.q` says.
            tells_motors: whether `.q` says how many there are.
            boot_loader: seconds that pass between a start and `.h`.
        """
        self.servos = tuple(servos)
        self.version = version
        self.tells_motors = tells_motors
        self.state = State.OFF
        self.led = False
        self.boots = 0
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("lines", "cut", "commands", "ignored", "restarts", "hangs"), 0)
        )
        self._boot_loader = boot_loader

    def program(self) -> Program:
        """Run from power-up for ever; it starts anew when a line has made it."""
        while True:
            yield from self._boot()
            try:
                while True:
                    line = yield from self._read_line()
                    yield from self._obey(line)
            except parsing.Restart:
                self.counters["restarts"] += 1
            except parsing.Hang:
                self.counters["hangs"] += 1
                self.state = State.HUNG
                yield Pause(math.inf)

    def _boot(self) -> _Part:
        self.boots += 1
        self.state = State.BOOTING
        self.led = False
        if self._boot_loader:
            yield Pause(self._boot_loader)
        yield from self._print(".h\n")
        for _ in range(_BLINKS):
            self.led = not self.led
            yield Pause(BLINKING / _BLINKS)

    def _read_line(self) -> Generator[Wish, int, bytes]:
        """Collect a line with its newline, or as much of it as the buffer holds."""
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

    def _obey(self, line: bytes) -> _Part:
        """Do what the second character says; the first may be anything."""
        self.state = State.ANSWERING
        self.counters["commands"] += 1
        match line[1:2]:
            case b"q":
                motors = f",{len(self.servos)}" if self.tells_motors else ""
                yield from self._print(f".q{self.version}{motors}\n")
            case b"v":
                yield from self._set_speeds(parsing.values(line, len(self.servos)))
            case b"c":
                yield from self._move(parsing.values(line, len(self.servos)))
            case b"l":
                self.led = {b"0": False, b"1": True}.get(line[2:3], self.led)
                yield from self._print(f".l{self.led:d}\n")
            case _:
                self.counters["commands"] -= 1
                self.counters["ignored"] += 1

    def _set_speeds(self, speeds: Sequence[int]) -> _Part:
        """Write all, wait, and tell what the servos hold then."""
        self.state = State.SPEEDS
        for servo, speed in zip(self.servos, speeds, strict=True):
            yield Pause(WRITING)
            servo.write_speed(speed)
        yield Pause(SPEED_PAUSE)
        yield from self._print(".v")
        for index, servo in enumerate(self.servos):
            yield Pause(READING)
            yield from self._print_value(servo.read(Register.SPEED), index)

    def _move(self, goals: Sequence[int]) -> _Part:
        """Write all, then wait for one servo after the other and tell where it is."""
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
    def _await(servo: Servo) -> _Part:
        """Poll the moving flag until it is 0; -1, no answer, is not."""
        while True:
            yield Pause(READING)
            if servo.read(Register.MOVING) == 0:
                return
            fatal_error = int(min(servo.remaining if servo.answers else _LUMP, _LUMP) / READING) - 1
            if fatal_error > 0:
                yield Pause(fatal_error * READING)

    def _print_value(self, value: int, index: int) -> _Part:
        is_last = index == len(self.servos) - 1
        yield from self._print(f"{value}\n" if is_last else f"{value},")

    def _print(self, text: str) -> _Part:
        r"""Put out a text; each newline gets a carriage return in front."""
        for byte in text.replace("\n", "\r\n").encode("ascii"):
            yield Transmit(byte)
