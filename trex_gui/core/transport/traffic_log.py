"""Every byte of a line as it passes, for whoever wants to read it later.

A `LoggingTransport` stands between a session and its port and notes what goes either way on a
`TrafficLog`, which another thread empties. Nothing is judged here: `exchanges` puts question and
answer together, and each device has its own words for them.
"""

import time
from collections import deque
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from enum import Enum, auto

from trex_gui.core.errors import StudioError, sentence
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat

_LONGEST_TAPE = 50_000
"""Pieces that are kept for a reader that is late: at 1,000 a second, nearly a minute."""


class TrafficDirection(Enum):
    """Where the bytes of a piece went, or that none did."""

    SENT = auto()
    RECEIVED = auto()
    LINE = auto()


@dataclass(frozen=True, slots=True)
class TrafficEvent:
    """What passed at one time.

    Attributes:
        time: seconds on the line's clock; received bytes may have waited in the port before.
        data: the bytes; none where something happened to the line itself.
        text: what happened to the line, for the user.
        settings: how the line is set from here on, where that is said.
    """

    time: float
    way: TrafficDirection
    data: bytes = b""
    text: str = ""
    settings: PortSettings | None = None


@dataclass(slots=True)
class TrafficLog:
    """Pieces between the thread of a line and one reader; bounded, and nobody ever waits.

    Attributes:
        lost: pieces that were dropped because the reader did not come.
    """

    lost: int = 0
    _pieces: deque[TrafficEvent] = field(default_factory=deque)

    def note(self, piece: TrafficEvent) -> None:
        """Add a piece, from the thread of the line."""
        if len(self._pieces) >= _LONGEST_TAPE:
            self.lost += 1
            return
        self._pieces.append(piece)

    def take(self) -> list[TrafficEvent]:
        """Return what was noted since the last time, in order; from the reader's thread."""
        count = len(self._pieces)  # what comes meanwhile stays for the next time
        return [self._pieces.popleft() for _ in range(count)]


class LoggingTransport:
    """A line whose bytes are noted; otherwise it does what the one below it does."""

    def __init__(self, below: Transport, settings: PortSettings, log: TrafficLog) -> None:
        self._below = below
        self._settings = settings
        self._line = settings.line
        self._tape = log

    @property
    def latency(self) -> float:
        return self._below.latency

    @property
    def is_configurable(self) -> bool:
        return self._below.is_configurable

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        return self._below.rates(wanted)

    def reconfigure(self, line: SerialFormat) -> None:
        self._below.reconfigure(line)
        if line != self._line:
            self._line = line
            self._note_line(f"Set to {line.text()}.", self._settings.at(line))

    def clock(self) -> float:
        return self._below.clock()

    def write(self, data: bytes) -> None:
        # Noted first: an answer must not stand before its question, nor one that failed be missing.
        self._tape.note(TrafficEvent(self._below.clock(), TrafficDirection.SENT, data))
        try:
            self._below.write(data)
        except StudioError as error:
            self._note_line(sentence(error))
            raise

    def read(self, size: int, seconds: float) -> bytes:
        try:
            data = self._below.read(size, seconds)
        except StudioError as error:
            self._note_line(sentence(error))
            raise
        return self._hear(data)

    def discard(self) -> bytes:
        try:
            data = self._below.discard()
        except StudioError as error:
            self._note_line(sentence(error))
            raise
        return self._hear(data)

    def wait(self, seconds: float) -> None:
        self._below.wait(seconds)

    def close(self) -> None:
        self._note_line("Closed.")
        self._below.close()

    def _hear(self, data: bytes) -> bytes:
        if data:
            self._tape.note(TrafficEvent(self._below.clock(), TrafficDirection.RECEIVED, data))
        return data

    def _note_line(self, text: str, settings: PortSettings | None = None) -> None:
        self._tape.note(
            TrafficEvent(self._below.clock(), TrafficDirection.LINE, text=text, settings=settings)
        )


def logged(
    log: TrafficLog,
    open_transport: Callable[[PortSettings], Transport] = SerialTransport,
    clock: Callable[[], float] = time.monotonic,
) -> Callable[[PortSettings], Transport]:
    """Return what opens a line as `open_transport` does, and notes its bytes on a tape.

    `clock` is the line's, for what is noted while there is no line yet.
    """

    def opened(settings: PortSettings) -> Transport:
        try:
            below = open_transport(settings)
        except StudioError as error:
            log.note(TrafficEvent(clock(), TrafficDirection.LINE, text=sentence(error)))
            raise
        text = f"Opened {settings.text()}."
        log.note(TrafficEvent(clock(), TrafficDirection.LINE, text=text, settings=settings))
        return LoggingTransport(below, settings, log)

    return opened
