"""Probe for a TReX at unknown line settings, without moving a motor.

A board at another rate misreads the bytes, and may mistake them for the start of a packet. Two
harmless probes could then form a motor command. Two rules prevent this.

- The only probe is 81 (get signature), alone or with its checksum. It changes nothing.
- Before each probe, `prober.flush` ends every packet that may have started. The effect of a probe
  then depends neither on earlier bytes nor on the order of the rates.

The tests send every probe to boards with every rate, polynomial and device number. No board
receives a motor command.
"""

import contextlib
from dataclasses import dataclass
from enum import Enum, auto
from itertools import product

from trex_gui.core.errors import BadReply
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.protocol.commands import GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import Framing, crc7
from trex_gui.devices.trex.protocol.line_settings import LineSettings

QUIET = 0.13
"""Seconds of silence after a probe. A board may reply to a misread probe, and receives nothing
during its reply. The longest reply, eleven bytes of eleven bits, takes 0.1 s at 1200 baud."""

UNSAFE = frozenset(product((14400, 28800), (0x2E, 0x4E)))
"""Pairs of baud rate and checksum that are not probed at unknown settings. A board at 8/3 of the
rate (38400, 76800 baud) with odd parity may receive 81 2E as F0 0E, which starts the auxiliary
motor. 81 4E can have the same effect."""

_PROBE = GetSignature().opcode.to_bytes()
_NAME = b"TReX"

_LOADER = b"?"  # follows the echo of each byte while the boot loader waits for firmware


def checksum(polynomial: int) -> int:
    return crc7(_PROBE, polynomial)


@dataclass(frozen=True, slots=True)
class Attempt:
    """Probe at certain line settings. All `polynomials` result in the same checksum."""

    line: LineSettings
    polynomials: tuple[int, ...] = ()
    number: int | None = None  # device number on a line with other devices

    @classmethod
    def at(cls, settings: ConnectionSettings) -> "Attempt":
        number = settings.device_number if settings.reserved else None
        return cls(settings.line, (settings.polynomial,) if settings.line.has_crc else (), number)

    @property
    def data(self) -> bytes:
        polynomial = self.polynomials[0] if self.polynomials else None
        return Framing(self.number, polynomial).encode(GetSignature())

    @property
    def is_unsafe(self) -> bool:
        """True if a board at other settings may mistake the probe for a motor command."""
        return len(self.data) == 2 and (self.line.baud, self.data[-1]) in UNSAFE


class ReplyKind(Enum):
    NOTHING = auto()
    STRANGE = auto()
    BOOT_LOADER = auto()
    SEVERAL = auto()
    BOARD = auto()
    BOARD_WITHOUT_CRC = auto()  # the board ignores the checksum of the probe


@dataclass(frozen=True, slots=True)
class ProbeReply:
    kind: ReplyKind
    data: bytes = b""
    echo: bool = False


def send_probe(wire: Transport, attempt: Attempt, extra: float = 0.0) -> ProbeReply:
    """Probe a flushed and configured line, and classify the reply. `extra`: additional wait (s)."""
    with contextlib.suppress(BadReply):
        wire.discard()
    wire.write(attempt.data)
    seconds = attempt.line.seconds(len(attempt.data)) + wire.latency + extra + QUIET
    received = wire.read(64, seconds)
    if received == b"".join(bytes((byte,)) + _LOADER for byte in attempt.data):
        return ProbeReply(ReplyKind.BOOT_LOADER, received)
    echo = received.startswith(attempt.data)
    reply = received.removeprefix(attempt.data)
    if not reply:
        return ProbeReply(ReplyKind.NOTHING, echo=echo)
    if _is_signature(reply):
        kind = ReplyKind.BOARD_WITHOUT_CRC if attempt.polynomials else ReplyKind.BOARD
    elif attempt.polynomials and _is_signature(reply[:-1]):
        kind = ReplyKind.BOARD
    else:
        kind = ReplyKind.SEVERAL if reply.startswith(_NAME) else ReplyKind.STRANGE
    return ProbeReply(kind, reply, echo)


def _is_signature(data: bytes) -> bool:
    try:
        GetSignature().parse(data)
    except BadReply:
        return False
    return True
