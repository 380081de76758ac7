"""One question to a line on which a board may have any settings, that moves nothing.

A board at another rate hears other bytes than those that were sent, and keeps what it takes
for the beginning of a packet: a question now and another one later, each harmless by itself,
can make a motor command between them. Two things keep a search from that.

- Only 81 is asked, alone or with its checksum: the signature, which changes nothing.
- Before each question goes FF, slowly (1200 baud). A board at that rate takes it for nothing
  at all, one at any other for a byte that no packet may have there. Whatever began ends, so
  what a question does never hangs on what was sent before, nor on the order of the rates.

The tests go through every board and every question: no motor command is heard, at any rate,
with any polynomial and any device number.
"""

import contextlib
from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum, auto
from itertools import product

from trex_gui.core.discovery.flush import flush
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import ask
from trex_gui.devices.trex.protocol.commands import GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.crc7 import crc7
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings

QUIET = 0.13
"""Seconds after a question in which nothing is sent: a misread question may be answered, and
a board that answers is deaf. Eleven bytes of eleven bits take 0.1 s at 1200 baud."""

UNSAFE = frozenset(product((14400, 28800), (0x2E, 0x4E)))
"""Rates and checksums that are not asked with where the board may be anywhere: one at 8/3 of the
rate (38400, 76800 baud) with odd parity may hear 81 2E as F0 0E, which starts the auxiliary
motor; 81 4E likewise."""

_ASK = GetSignature().opcode.to_bytes()
_NAME = b"TReX"


def checksum(polynomial: int) -> int:
    """Return what stands behind the question under a CRC polynomial."""
    return crc7(_ASK, polynomial)


@dataclass(frozen=True, slots=True)
class Attempt:
    """One question: how it is sent, and the polynomials that its checksum may stand for."""

    line: LineSettings
    polynomials: tuple[int, ...] = ()

    @classmethod
    def at(cls, settings: ConnectionSettings) -> "Attempt":
        """Return the question for a board with these settings."""
        crc = settings.line.detection is Detection.CRC7
        return cls(settings.line, (settings.polynomial,) if crc else ())

    @property
    def question(self) -> bytes:
        """The bytes that ask for the signature."""
        if not self.polynomials:
            return _ASK
        return _ASK + bytes([checksum(self.polynomials[0])])

    @property
    def is_unsafe(self) -> bool:
        """Whether a board at some other settings may hear an order in the question."""
        return bool(self.polynomials) and (self.line.baud, self.question[-1]) in UNSAFE


class ReplyKind(Enum):
    """What came back to a question."""

    NOTHING = auto()
    ECHO = auto()
    STRANGE = auto()
    SEVERAL = auto()
    BOARD = auto()


@dataclass(frozen=True, slots=True)
class ProbeReply:
    """What came back to a question: its kind, the bytes, and whether the question did too."""

    answer: ReplyKind
    data: bytes = b""
    echo: bool = False


def send_probe(wire: Transport, attempt: Attempt, patience: float = 0.0) -> ProbeReply:
    """Ask once on a line that was rinsed and set, and judge what comes back.

    Raises:
        PortUnavailable: the line is gone.
    """
    question = attempt.question
    with contextlib.suppress(BadReply):
        wire.discard()
    wire.write(question)
    seconds = attempt.line.seconds(len(question)) + wire.latency + patience + QUIET
    data = wire.read(64, seconds)
    echo = data.startswith(question)
    answer = data.removeprefix(question)
    if not answer:
        return ProbeReply(ReplyKind.ECHO if echo else ReplyKind.NOTHING, data, echo)
    body = answer[:-1] if attempt.polynomials else answer
    try:
        GetSignature().parse(body)
    except BadReply:
        several = answer.startswith(_NAME)
        return ProbeReply(ReplyKind.SEVERAL if several else ReplyKind.STRANGE, answer, echo)
    return ProbeReply(ReplyKind.BOARD, answer, echo)


def is_board_at(wire: Transport, settings: ConnectionSettings, *, echo: bool) -> bool:
    """Return whether the board answers at these settings; the line is set to them then.

    A board that is addressed by number is so only where somebody has answered. Takes as long
    as one question, some 0.3 s on a local port, while nobody answers.

    Raises:
        BadRequest: the port cannot be set so.
        PortUnavailable: the line is gone.
    """
    flush(wire, settings.timeouts.extra)
    wire.reconfigure(settings.line)
    heard = send_probe(wire, Attempt.at(settings), settings.timeouts.extra)
    if heard.answer not in {ReplyKind.BOARD, ReplyKind.SEVERAL}:
        return False
    try:
        ask(TrexClient(wire, settings, echo=echo).request, GetSignature())
    except (NoReply, BadReply):
        return False
    return True


def reconnect_places(
    used: ConnectionSettings, expected: Iterable[ConnectionSettings]
) -> tuple[ConnectionSettings, ...]:
    """Return the settings at which a silent board may be, those in use first.

    The factory's line settings come last: a power cut while UART settings were being stored
    leaves them. A board answers with one stop bit as well as with two, so where nothing else
    is expected to change, what is expected stands for what is in use. Left out is a question
    that a board at another of these places could take for an order.
    """
    here = [replace(one, url=used.url, name=used.name, timeouts=used.timeouts) for one in expected]
    first = next((one for one in here if _differ_in_stop_bits(one, used)), used)
    places: dict[object, ConnectionSettings] = {}
    for place in (first, *here, replace(first, line=LineSettings())):
        places.setdefault((place.line, place.framing), place)
    return tuple(
        place
        for place in places.values()
        if not (Attempt.at(place).is_unsafe and _may_mishear(place.line, places.values()))
    )


def _differ_in_stop_bits(one: ConnectionSettings, other: ConnectionSettings) -> bool:
    """Whether two settings differ in nothing else, and in that."""
    stop_bits = other.line.stop_bits
    alike = replace(one, line=replace(one.line, stop_bits=stop_bits)) == other
    return alike and one.line.stop_bits != stop_bits


def _may_mishear(line: LineSettings, places: Iterable[ConnectionSettings]) -> bool:
    """Whether a board at one of the places may hear an order in an unsafe question."""
    return any(
        place.line.detection is Detection.ODD and place.line.baud * 3 == line.baud * 8
        for place in places
    )
