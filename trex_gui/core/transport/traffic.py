"""Traffic of a line, as bytes and as pairs of request and reply."""

import itertools
import time
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import Enum, auto

from trex_gui.core.errors import StudioError, sentence
from trex_gui.core.translation import tr
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat

SEARCH = "search: "  # prefix of the meaning of bytes that a device search has sent

_MAX_EVENTS = 50_000  # events queued for a slow reader: nearly a minute at 1,000 events/s


class TrafficDirection(Enum):
    """Direction of bytes. `LINE`: event of the line itself."""

    SENT = auto()
    RECEIVED = auto()
    LINE = auto()


@dataclass(frozen=True, slots=True)
class TrafficEvent:
    time: float  # clock of the line (s); received bytes may have arrived earlier
    direction: TrafficDirection
    data: bytes = b""
    text: str = ""  # sentence about an event of the line, for the user
    settings: PortSettings | None = None  # new line settings, if they have changed


@dataclass(slots=True)
class TrafficLog:
    """Queue of events from a line's thread to one reader.

    The queue is bounded and never blocks. `lost` counts the events that were dropped because the
    reader was slow.
    """

    lost: int = 0
    _events: deque[TrafficEvent] = field(default_factory=deque)

    def record(self, event: TrafficEvent) -> None:
        if len(self._events) >= _MAX_EVENTS:
            self.lost += 1
            return
        self._events.append(event)

    def pop(self) -> list[TrafficEvent]:
        """Return the new events in order. Called in the reader's thread."""
        count = len(self._events)  # the next call returns later events
        return [self._events.popleft() for _ in range(count)]


class LoggingTransport:
    """Passes all calls to another transport, and their traffic to `record`."""

    def __init__(
        self, below: Transport, settings: PortSettings, record: Callable[[TrafficEvent], None]
    ) -> None:
        self._below = below
        self._settings = settings
        self._line = settings.line
        self._record = record
        self.rates = below.rates
        self.clock = below.clock
        self.wait = below.wait
        self.start_guardian = below.start_guardian
        self.latency = below.latency
        self.is_configurable = below.is_configurable

    def reconfigure(self, line: SerialFormat) -> None:
        self._below.reconfigure(line)
        if line != self._line:
            self._line = line
            self._record_line(f"Set to {line.text()}.", self._settings.at(line))

    def write(self, data: bytes) -> None:
        # Recorded before the write, so that the reply follows and a failed write is recorded, too.
        self._record(TrafficEvent(self.clock(), TrafficDirection.SENT, data))
        with self._logged_errors():
            self._below.write(data)

    def read(self, size: int, seconds: float) -> bytes:
        with self._logged_errors():
            return self._received(self._below.read(size, seconds))

    def discard(self) -> bytes:
        with self._logged_errors():
            return self._received(self._below.discard())

    def close(self) -> None:
        self._record_line("Closed.")
        self._below.close()

    @contextmanager
    def _logged_errors(self) -> Iterator[None]:
        try:
            yield
        except StudioError as error:
            self._record_line(sentence(error))
            raise

    def _received(self, data: bytes) -> bytes:
        if data:
            self._record(TrafficEvent(self.clock(), TrafficDirection.RECEIVED, data))
        return data

    def _record_line(self, text: str, settings: PortSettings | None = None) -> None:
        event = TrafficEvent(self.clock(), TrafficDirection.LINE, text=text, settings=settings)
        self._record(event)


def logged(
    record: Callable[[TrafficEvent], None],
    open_transport: Callable[[PortSettings], Transport] = SerialTransport,
    clock: Callable[[], float] = time.monotonic,
) -> Callable[[PortSettings], Transport]:
    """Wrap `open_transport` so that `record` receives the traffic.

    `clock`: clock of the line, for events that happen before the line is open.
    """

    def open_logged(settings: PortSettings) -> Transport:
        try:
            below = open_transport(settings)
        except StudioError as error:
            record(TrafficEvent(clock(), TrafficDirection.LINE, text=sentence(error)))
            raise
        text = tr("Opened {0}.").format(settings.text())
        record(TrafficEvent(clock(), TrafficDirection.LINE, text=text, settings=settings))
        return LoggingTransport(below, settings, record)

    return open_logged


@dataclass(frozen=True, slots=True)
class Decoded:
    """Meaning of a transaction. `is_fault`: True if the transaction has failed."""

    text: str
    is_fault: bool = False


@dataclass(slots=True, eq=False)
class Transaction:
    """Row of traffic: a request and its reply, or a line event."""

    number: int  # row number from 1
    time: float  # time of sending, otherwise of the first received byte, on the line's clock (s)
    sent: bytes = b""
    received: bytes = b""
    note: str = ""  # text of a line event; only in rows without bytes
    settings: PortSettings | None = None
    echo: bool | None = None  # True if all sent bytes come back; `None`: unknown
    is_routine: bool = False  # True for a periodic poll by the program
    ended: float | None = None  # time of the last received byte
    is_over: bool = False
    is_search: bool = False  # sent by a device search, in which most probes receive no reply
    cached_meaning: Decoded | None = None  # cached result of `Decoder.decoded`

    @property
    def seconds(self) -> float | None:
        return None if self.ended is None or not self.sent else self.ended - self.time


class Decoder(ABC):
    """Explains the bytes of one kind of device."""

    @abstractmethod
    def display_text(self, data: bytes) -> str:
        """Return bytes as text for display, which may be hexadecimal."""

    @abstractmethod
    def bytes_of(self, text: str) -> bytes:
        """Convert text from `display_text` back to bytes. Raises ValueError."""

    def learn(self, transaction: Transaction) -> None:
        """Store facts about the device from a reply, such as its units."""
        del transaction

    @abstractmethod
    def is_routine(self, sent: bytes) -> bool:
        """Return whether these bytes are a periodic poll by the program."""

    @abstractmethod
    def may_move(self, sent: bytes) -> bool:
        """Return whether these bytes may start a motor."""

    @abstractmethod
    def is_whole(self, transaction: Transaction) -> bool:
        """Return whether the reply is complete. Later bytes are unsolicited."""

    def goes_with(self, transaction: Transaction, sent: bytes) -> bool:
        """Return whether bytes sent later belong to the row of a pending transaction.

        Bytes received afterwards may then be the reply to either request.
        """
        del transaction, sent
        return False

    @abstractmethod
    def read(self, transaction: Transaction) -> Decoded:
        """Return the meaning of a transaction that has bytes."""

    def is_fault(self, transaction: Transaction) -> bool:
        """Return whether a transaction has failed."""
        return self.decoded(transaction).is_fault

    def decoded(self, transaction: Transaction) -> Decoded:
        """Return the meaning of a transaction, which is cached once the transaction is over."""
        # Read only once, because another thread may clear the cache.
        if (known := transaction.cached_meaning) is not None:
            return known
        meaning = Decoded(transaction.note) if transaction.note else self.read(transaction)
        if transaction.is_search:
            meaning = Decoded(f"{SEARCH}{meaning.text}")
        if transaction.is_over:
            transaction.cached_meaning = meaning
        return meaning


class TransactionAssembler:
    """Assembles the events of one line into rows of request and reply.

    `numbers` yields the row numbers. `is_search`: the events belong to a device search.
    """

    def __init__(
        self, decoder: Decoder, *, numbers: Iterator[int] | None = None, is_search: bool = False
    ) -> None:
        self._decoder = decoder
        self._numbers = itertools.count(1) if numbers is None else numbers
        self._is_search = is_search
        # A session sets these attributes, because the traffic log does not contain them.
        self.settings: PortSettings | None = None
        self.echo: bool | None = None
        self._pending: Transaction | None = None

    def feed(self, events: Iterable[TrafficEvent]) -> list[Transaction]:
        """Process events. Return new and changed rows in order."""
        changed: dict[int, Transaction] = {}
        for event in events:
            row = self._pending
            if row is None or not self._continues(row, event):
                if row is not None:
                    row.is_over = True
                    changed[row.number] = row
                self.settings = event.settings or self.settings
                row = self._row(event)
                self._pending = None if row.is_over else row
            elif event.direction is TrafficDirection.SENT:
                row.sent += event.data
            if event.direction is TrafficDirection.RECEIVED:
                row.received += event.data
                row.ended = event.time
            changed[row.number] = row
        return list(changed.values())

    def _continues(self, row: Transaction, event: TrafficEvent) -> bool:
        match event.direction:
            case TrafficDirection.SENT:
                return self._decoder.goes_with(row, event.data)
            case TrafficDirection.RECEIVED:
                return not row.received or not self._decoder.is_whole(row)
        return False

    def _row(self, event: TrafficEvent) -> Transaction:
        sent = event.data if event.direction is TrafficDirection.SENT else b""
        return Transaction(
            next(self._numbers),
            event.time,
            sent,
            note=event.text,
            settings=self.settings,
            echo=self.echo,
            is_routine=bool(sent) and self._decoder.is_routine(sent),
            is_over=event.direction is TrafficDirection.LINE,
            is_search=self._is_search,
        )
