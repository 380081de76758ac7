"""One probe on a line on which a board may have any settings; it moves nothing.

A board at another rate receives other bytes than those that were sent, and keeps what it takes
for the start of a packet: two probes, each harmless by itself, could form a motor command. Two
rules prevent that.

- The only probe is 81, alone or with its checksum: the signature, which changes nothing.
- Before each probe `core.discovery.flush` ends every packet that may have begun, so the effect
  of a probe depends neither on what was sent before nor on the order of the rates.

The tests send every probe to every board: none receives a motor command, at any rate, with any
polynomial and any device number.
"""

import contextlib
from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum, auto
from itertools import product

from trex_gui.core.discovery.prober import flush
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import query
from trex_gui.devices.trex.protocol.commands import GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import crc7
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings

QUIET = 0.13
"""Seconds after a probe in which nothing is sent: a misread probe may be answered, and a board that
answers is deaf. Eleven bytes of eleven bits take 0.1 s at 1200 baud."""

UNSAFE = frozenset(product((14400, 28800), (0x2E, 0x4E)))
"""Rates and checksums that are not probed where the board may be anywhere: at 8/3 of the rate
(38400, 76800 baud) with odd parity it may receive 81 2E as F0 0E, which starts the auxiliary
motor; 81 4E likewise."""

_ASK = GetSignature().opcode.to_bytes()
_NAME = b"TReX"


def checksum(polynomial: int) -> int:
    """Return the checksum of the probe under a CRC polynomial."""
    return crc7(_ASK, polynomial)


@dataclass(frozen=True, slots=True)
class Attempt:
    """One probe: its line settings, and the polynomials that give its checksum."""

    line: LineSettings
    polynomials: tuple[int, ...] = ()

    @classmethod
    def at(cls, settings: ConnectionSettings) -> "Attempt":
        """Return the probe for a board with these settings."""
        crc = settings.line.detection is Detection.CRC7
        return cls(settings.line, (settings.polynomial,) if crc else ())

    @property
    def question(self) -> bytes:
        """The bytes of the probe."""
        if not self.polynomials:
            return _ASK
        return _ASK + bytes([checksum(self.polynomials[0])])

    @property
    def is_unsafe(self) -> bool:
        """Whether a board at some other settings may take the probe for a motor command."""
        return bool(self.polynomials) and (self.line.baud, self.question[-1]) in UNSAFE


class ReplyKind(Enum):
    """What came back after a probe."""

    NOTHING = auto()
    ECHO = auto()
    STRANGE = auto()
    SEVERAL = auto()
    BOARD = auto()


@dataclass(frozen=True, slots=True)
class ProbeReply:
    """What came back after a probe: its kind, the bytes, and whether the probe itself did."""

    answer: ReplyKind
    data: bytes = b""
    echo: bool = False


def send_probe(wire: Transport, attempt: Attempt, extra: float = 0.0) -> ProbeReply:
    """Send a probe on a line that was flushed and set, and classify the reply.

    Raises:
        PortUnavailable: the line is gone.
    """
    question = attempt.question
    with contextlib.suppress(BadReply):
        wire.discard()
    wire.write(question)
    seconds = attempt.line.seconds(len(question)) + wire.latency + extra + QUIET
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

    Without a reply it takes about 0.3 s on a local port. A board that is addressed by number gets
    a second query with it.

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
        query(TrexClient(wire, settings, echo=echo).request, GetSignature())
    except (NoReply, BadReply):
        return False
    return True


def reconnect_places(
    used: ConnectionSettings, expected: Iterable[ConnectionSettings]
) -> tuple[ConnectionSettings, ...]:
    """Return the settings at which a silent board may be, those in use first.

    The factory default comes last: a power cut while UART settings were being stored leaves it. A
    board answers with one stop bit as well as with two, so candidates that differ only in these
    replace the settings in use. A probe that a board at another of these places could take for a
    motor command is left out.
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
    """Whether two settings differ in the stop bits only."""
    stop_bits = other.line.stop_bits
    alike = replace(one, line=replace(one.line, stop_bits=stop_bits)) == other
    return alike and one.line.stop_bits != stop_bits


def _may_mishear(line: LineSettings, places: Iterable[ConnectionSettings]) -> bool:
    """Whether a board at one of the places may take an unsafe probe for a motor command."""
    return any(
        place.line.detection is Detection.ODD and place.line.baud * 3 == line.baud * 8
        for place in places
    )
