"""Finding a board whose serial settings nobody knows, without moving anything.

A board at another rate hears other bytes than those that were sent, and keeps what it takes
for the beginning of a packet: a question now and another one later, each harmless by itself,
can make a motor command between them. Two things keep this search from that.

- Only 81 is asked, alone or with its checksum: the signature, which changes nothing.
- Before each question goes FF, slowly (1200 baud). A board at that rate takes it for nothing
  at all, one at any other for a byte that no packet may have there. Whatever began ends, so
  what a question does never hangs on what was sent before, nor on the order of the rates.

The tests go through every board and every question: no motor command is heard, at any rate,
with any polynomial and any device number.
"""

import contextlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from enum import Enum, auto
from itertools import product
from typing import Protocol

import serial

from trex_gui.link.client import Client
from trex_gui.link.reading import ask
from trex_gui.link.settings import LinkSettings
from trex_gui.link.transport import PARITIES, PORT_ERRORS, SerialTransport, Transport
from trex_gui.protocol.commands import GetParameter, GetSignature, Signature
from trex_gui.protocol.crc7 import DEFAULT_POLYNOMIAL, crc7
from trex_gui.protocol.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.protocol.parameters import parameter_number

RINSE = b"\xff"
RINSE_LINE = LineSettings(1200)
"""What ends every packet that a board may have begun, and how it is sent."""

QUIET = 0.13
"""Seconds after a question in which nothing is sent: a misread question may be answered, and
a board that answers is deaf. Eleven bytes of eleven bits take 0.1 s at 1200 baud."""

_LIKELY = (19200, 115200, 9600, 38400, 57600)
_NAME = b"TReX"

_LOADER = b"?"
"""What a board that waits for firmware answers to anything, behind an echo."""


_ASK = GetSignature().opcode.to_bytes()
_LOOK = 0.3
"""Seconds to listen for something that talks by itself."""

_UNSAFE = set(product((14400, 28800), (0x2E, 0x4E)))
"""Rates and checksums that are not asked with: a board at 8/3 of the rate (38400, 76800 baud)
with odd parity may hear 81 2E as F0 0E, which starts the auxiliary motor; 81 4E likewise. So ten
of the polynomials are not found at these two rates."""


@dataclass(frozen=True, slots=True)
class Attempt:
    """One question: how it is sent, and the polynomials that its checksum may stand for."""

    line: LineSettings
    polynomials: tuple[int, ...] = ()

    @property
    def question(self) -> bytes:
        """The bytes that ask for the signature."""
        if not self.polynomials:
            return _ASK
        return _ASK + bytes([crc7(_ASK, self.polynomials[0])])


def attempts(*, full: bool = False) -> Iterator[Attempt]:
    """Return every question in the order in which to ask, the likely ones first.

    `full` adds every other CRC-7 polynomial than the factory's, which takes some minutes.
    """
    rates = sorted(baud_rates(), key=lambda baud: (baud not in _LIKELY, _rank(baud)))
    for stop_bits in (1, 2):
        for detection in (Detection.NONE, Detection.EVEN, Detection.ODD):
            for baud in rates:
                yield Attempt(LineSettings(baud, detection, stop_bits))
        for baud in rates:
            line = LineSettings(baud, Detection.CRC7, stop_bits)
            yield Attempt(line, (DEFAULT_POLYNOMIAL,))
    if not full:
        return
    alike: dict[int, list[int]] = {}
    for polynomial in range(0x80, 0x100):
        if polynomial != DEFAULT_POLYNOMIAL:
            alike.setdefault(crc7(_ASK, polynomial), []).append(polynomial)
    for stop_bits, baud, (checksum, polynomials) in product((1, 2), rates, alike.items()):
        if (baud, checksum) not in _UNSAFE:
            yield Attempt(LineSettings(baud, Detection.CRC7, stop_bits), tuple(polynomials))


def _rank(baud: int) -> int:
    return _LIKELY.index(baud) if baud in _LIKELY else -baud


class Wire(Transport, Protocol):
    """A line whose settings can be changed while it is open."""

    def tune(self, line: LineSettings) -> None:
        """Go on with these settings.

        Raises:
            BadRequest: the port cannot be set so.
        """
        ...


class SerialWire(SerialTransport):
    """A port that stays open, and no other program's, for the whole search."""

    def tune(self, line: LineSettings) -> None:
        port = self._port
        wanted = {
            "baudrate": line.baud,
            "parity": PARITIES.get(line.detection, serial.PARITY_NONE),
            "stopbits": serial.STOPBITS_TWO if line.stop_bits == 2 else serial.STOPBITS_ONE,
        }
        try:
            for name, value in wanted.items():
                if getattr(port, name) != value:
                    setattr(port, name, value)
        except PORT_ERRORS as error:
            raise BadRequest(f"the port cannot be set to {line.text()}") from error


@dataclass(frozen=True, slots=True)
class Found:
    """A board, and how to reach it.

    Attributes:
        settings: what to connect with; addressed by number only where several boards share
            the line.
        signature: which board it is.
        device_number: the number that it answers to, where it said so.
        note: what else to know of it, for people; may be empty.
    """

    settings: LinkSettings
    signature: Signature
    device_number: int | None = None
    echo: bool = False
    note: str = ""


class Answer(Enum):
    """What came back to a question."""

    NOTHING = auto()
    ECHO = auto()
    STRANGE = auto()
    SEVERAL = auto()
    BOARD = auto()


@dataclass(frozen=True, slots=True)
class Step:
    """How far a search is: `done` of `total` questions; `line` is asked on next."""

    done: int
    total: int
    line: LineSettings


@dataclass(slots=True)
class Search:
    """What a search has seen.

    Attributes:
        found: boards; more than one only where several share the line.
        echo: whether what was sent came back.
        strange: what answered otherwise, and at which settings, first things first.
        skipped: settings that the port cannot have.
        cancelled: whether it ended early because it was asked to.
    """

    url: str
    found: list[Found] = field(default_factory=list)
    echo: bool = False
    strange: list[tuple[LineSettings, bytes]] = field(default_factory=list)
    several: LineSettings | None = None
    skipped: list[LineSettings] = field(default_factory=list)
    cancelled: bool = False

    def verdict(self) -> str:
        """Say what was seen where no board was found, and what to look at."""
        if self.several is not None:
            return (
                f"Several boards answer at once on {self.url} at {self.several.text()}. "
                "The full search asks for each device number."
            )
        if self.strange:
            line, data = self.strange[0]
            shown = data[:12].hex(" ").upper() + (" …" if len(data) > 12 else "")
            if all(data == _LOADER for _, data in self.strange):
                return (
                    f"What is connected to {self.url} answers as a TReX that waits for new "
                    "firmware. Take the SO-G jumper off, then switch the board off and on."
                )
            return (
                f"Something is connected to {self.url}, but it does not answer as a TReX does: "
                f"{shown} came at {line.text()}. Another device, or a line that is disturbed."
            )
        if self.echo:
            return (
                f"Everything sent on {self.url} comes back, and nothing else, at every rate. "
                "Either this is the RS-232 side of a board that is off, or the adapter's TX and "
                "RX are joined."
            )
        return (
            f"No TReX answers on {self.url} at any baud rate, with any parity or with CRC. Check "
            "that the board has power (an LED is lit), that the adapter's TX goes to SI and its "
            "RX to SO (or both RS-232 pins, never mixed), and that ground is connected. A board "
            "with a CRC polynomial of its own is only found by the full search."
        )


def _silent(step: Step) -> None:
    del step


def _never() -> bool:
    return False


def find(
    settings: LinkSettings,
    open_wire: Callable[[LinkSettings], Wire] = SerialWire,
    progress: Callable[[Step], None] = _silent,
    cancelled: Callable[[], bool] = _never,
    *,
    full: bool = False,
) -> Search:
    """Look for a board on a port, whatever it is set to; end with the first that answers.

    Args:
        settings: the port, and how patient to be; line and framing do not matter.
        open_wire: opens the port.
        progress: called before each question.
        cancelled: asked before each question whether to end.
        full: try every polynomial, and ask a found line for each device number. All boards
            on that line must run at its rate then.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    plan = list(attempts(full=full))
    wire = open_wire(replace(settings, line=RINSE_LINE, device_number=None))
    search = Search(settings.name or settings.url)
    try:
        seeker = _Seeker(wire, settings, search)
        seeker.listen()
        for done, attempt in enumerate(plan):
            if cancelled():
                search.cancelled = True
                break
            progress(Step(done, len(plan), attempt.line))
            if seeker.try_out(attempt, full=full):
                break
    finally:
        # A byte that is on its way must not change its rate. And some boards with USB start
        # their loader when a port is closed at 1200 baud.
        wire.wait(RINSE_LINE.seconds(2) + wire.latency)
        with contextlib.suppress(BadRequest, PortUnavailable):
            wire.tune(LineSettings())
        wire.close()
    return search


class _Seeker:
    """Asks on one line, and remembers in a search what it saw."""

    def __init__(self, wire: Wire, settings: LinkSettings, search: Search) -> None:
        self._wire = wire
        self._settings = settings
        self._search = search

    def listen(self) -> None:
        """Notice what talks without being asked."""
        with contextlib.suppress(BadReply):
            self._wire.discard()
        if data := self._wire.read(16, _LOOK):
            self._search.strange.append((RINSE_LINE, data))

    def try_out(self, attempt: Attempt, *, full: bool) -> bool:
        """Ask once; return whether the search is over."""
        self._rinse()
        try:
            self._wire.tune(attempt.line)
        except BadRequest:
            self._search.skipped.append(attempt.line)
            return False
        answer, data = self._ask(attempt)
        found = self._confirm(attempt) if answer is Answer.BOARD else None
        if found is not None:
            self._search.found.append(found)
        elif answer is Answer.SEVERAL:
            self._search.several = attempt.line
        else:
            if answer in {Answer.STRANGE, Answer.BOARD}:
                self._search.strange.append((attempt.line, data))
            return False
        if full:
            self._ask_each_number(attempt)
        return True

    def _rinse(self) -> None:
        self._wire.tune(RINSE_LINE)
        self._wire.write(RINSE)
        self._wire.wait(RINSE_LINE.seconds(len(RINSE)) + self._slack)

    @property
    def _slack(self) -> float:
        """Seconds that a byte may take from the program to the wire, or back."""
        return self._wire.latency + self._settings.patience

    def _ask(self, attempt: Attempt) -> tuple[Answer, bytes]:
        question = attempt.question
        with contextlib.suppress(BadReply):
            self._wire.discard()
        self._wire.write(question)
        seconds = attempt.line.seconds(len(question)) + self._slack + QUIET
        data = self._wire.read(64, seconds)
        answer = data
        if data.startswith(question):
            answer = data[len(question) :]
            self._search.echo = True
        if not answer:
            return Answer.ECHO if data else Answer.NOTHING, data
        body = answer[:-1] if attempt.polynomials else answer
        try:
            GetSignature().parse(body)
        except BadReply:
            several = answer.startswith(_NAME)
            return Answer.SEVERAL if several else Answer.STRANGE, answer
        return Answer.BOARD, answer

    def _confirm(self, attempt: Attempt) -> Found | None:
        """Ask a board that answered for more, at settings which it now is known to have."""
        for polynomial in attempt.polynomials or (DEFAULT_POLYNOMIAL,):
            settings = replace(
                self._settings, line=attempt.line, device_number=None, polynomial=polynomial
            )
            client = Client(self._wire, settings, echo=self._search.echo)
            try:
                signature = ask(client.request, GetSignature())
                number = ask(client.request, GetParameter(parameter_number("device_number")))
                stored = ask(client.request, GetParameter(parameter_number("uart_settings")))
            except (NoReply, BadReply):
                continue
            note = _note(attempt.line, signature, stored)
            return Found(settings, signature, number, self._search.echo, note)
        return None

    def _ask_each_number(self, attempt: Attempt) -> None:
        """Look which device numbers answer; several that do replace what answered for all."""
        polynomial = self._search.found[0].settings.polynomial if self._search.found else None
        polynomial = polynomial or (attempt.polynomials or (DEFAULT_POLYNOMIAL,))[0]
        by_number: list[Found] = []
        for number in range(128):
            settings = replace(
                self._settings, line=attempt.line, device_number=number, polynomial=polynomial
            )
            client = Client(self._wire, settings, echo=self._search.echo)
            with contextlib.suppress(NoReply, BadReply):
                signature = client.request(GetSignature())
                by_number.append(Found(settings, signature, number, self._search.echo))
        if len(by_number) > 1 or not self._search.found:
            self._search.found = by_number


def _note(line: LineSettings, signature: Signature, stored: int) -> str:
    """Say how what a board has stored differs from how it was reached."""
    try:
        kept = LineSettings.from_wire(stored)
    except BadRequest:
        return f"Its UART settings hold {stored:#04x}, which is no setting that is known."
    if kept == line:
        return ""
    real = kept.real_baud(signature.firmware)
    if real != kept.baud and real == line.baud:
        return (
            f"It is set to {kept.baud} baud, which firmware {signature.firmware} runs at half "
            f"the rate: connect at {line.baud}."
        )
    if replace(kept, stop_bits=line.stop_bits) == line:
        return f"It is set to {kept.stop_bits} stop bits; both numbers work on this line."
    return f"Switched off and on, it will run at {kept.text()}."
