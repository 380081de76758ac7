"""Traffic log: every byte of a line as it passes, for a reader in another thread.

A `LoggingTransport` between a session and its port adds what it sends and receives to a
`TrafficLog`. Nothing is interpreted here: `transactions` pairs requests and replies, and each
device has a decoder.
"""

import time
from collections import deque
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from enum import Enum, auto

from trex_gui.core.errors import StudioError, sentence
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat

_MOST_EVENTS = 50_000
"""Events that are kept for a reader that is late: at 1,000 a second, nearly a minute."""


class TrafficDirection(Enum):
    """Direction of the bytes; `LINE`: something happened to the line itself."""

    SENT = auto()
    RECEIVED = auto()
    LINE = auto()


@dataclass(frozen=True, slots=True)
class TrafficEvent:
    """What passed at one moment.

    Attributes:
        time: seconds on the line's clock; received bytes may have waited in the port before.
        data: the bytes; none if something happened to the line itself.
        text: what happened to the line, for the user.
        settings: settings of the line from here on, if they changed.
    """

    time: float
    way: TrafficDirection
    data: bytes = b""
    text: str = ""
    settings: PortSettings | None = None


@dataclass(slots=True)
class TrafficLog:
    """Queue of events from the thread of a line to one reader; bounded, never blocks.

    Attributes:
        lost: events that were dropped because the reader was late.
    """

    lost: int = 0
    _events: deque[TrafficEvent] = field(default_factory=deque)

    def note(self, event: TrafficEvent) -> None:
        """Add an event, from the thread of the line."""
        if len(self._events) >= _MOST_EVENTS:
            self.lost += 1
            return
        self._events.append(event)

    def take(self) -> list[TrafficEvent]:
        """Return the events since the last call, in order; from the reader's thread."""
        count = len(self._events)  # those added meanwhile stay for the next call
        return [self._events.popleft() for _ in range(count)]


class LoggingTransport:
    """Logs the bytes of the transport below it; otherwise does what that does."""

    def __init__(self, below: Transport, settings: PortSettings, log: TrafficLog) -> None:
        self._below = below
        self._settings = settings
        self._line = settings.line
        self._log = log

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
        # Logged first: before its reply, and also if it fails.
        self._log.note(TrafficEvent(self._below.clock(), TrafficDirection.SENT, data))
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
        return self._received(data)

    def discard(self) -> bytes:
        try:
            data = self._below.discard()
        except StudioError as error:
            self._note_line(sentence(error))
            raise
        return self._received(data)

    def wait(self, seconds: float) -> None:
        self._below.wait(seconds)

    def close(self) -> None:
        self._note_line("Closed.")
        self._below.close()

    def _received(self, data: bytes) -> bytes:
        if data:
            self._log.note(TrafficEvent(self._below.clock(), TrafficDirection.RECEIVED, data))
        return data

    def _note_line(self, text: str, settings: PortSettings | None = None) -> None:
        self._log.note(
            TrafficEvent(self._below.clock(), TrafficDirection.LINE, text=text, settings=settings)
        )


def logged(
    log: TrafficLog,
    open_transport: Callable[[PortSettings], Transport] = SerialTransport,
    clock: Callable[[], float] = time.monotonic,
) -> Callable[[PortSettings], Transport]:
    """Return a function that opens a line as `open_transport` does and logs its bytes.

    `clock` is the line's, for events before there is a line.
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
