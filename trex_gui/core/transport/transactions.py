"""Transactions: requests and replies paired again from the bytes of a line.

A row of the traffic page is a `Transaction`: what was sent, what was received until the next was
sent, and how long that took. Each device has a `Decoder` for its meaning.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass

from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic_log import TrafficDirection, TrafficEvent


@dataclass(frozen=True, slots=True)
class Decoded:
    """Meaning of a transaction; `is_fault` if something went wrong in it."""

    text: str
    is_fault: bool = False


@dataclass(slots=True, eq=False)
class Transaction:
    """One row: a request and its reply, or something that happened to the line.

    Attributes:
        number: counts the rows from 1.
        time: when it was sent, or when the first byte was received if nothing was sent. Seconds
            on the line's clock.
        sent, received: the bytes; neither has any if `note` says what happened to the line.
        ended: when the last byte was received, on the same clock; `None` if none was.
        settings: settings of the line.
        echo: whether everything sent comes back; `None`: not known yet.
        is_routine: whether it is one of the polls that the program repeats all the time.
        is_over: whether it is complete.
        words: its meaning, once it was decoded; see `Decoder.decoded`.
    """

    number: int
    time: float
    sent: bytes = b""
    received: bytes = b""
    note: str = ""
    settings: PortSettings | None = None
    echo: bool | None = None
    is_routine: bool = False
    ended: float | None = None
    is_over: bool = False
    words: Decoded | None = None

    @property
    def seconds(self) -> float | None:
        """Seconds from the first byte sent to the last one received; `None` without a reply."""
        return None if self.ended is None or not self.sent else self.ended - self.time


class Decoder(ABC):
    """Decodes the bytes of one kind of device."""

    @abstractmethod
    def shown(self, data: bytes) -> str:
        """Return bytes as they are displayed: hexadecimal, or text."""

    @abstractmethod
    def is_routine(self, sent: bytes) -> bool:
        """Return whether these bytes are a poll that the program repeats all the time."""

    @abstractmethod
    def is_whole(self, transaction: Transaction) -> bool:
        """Return whether the reply is complete; bytes behind it are unsolicited."""

    def goes_with(self, transaction: Transaction, sent: bytes) -> bool:
        """Return whether these bytes belong to the pending row, although they were sent later.

        What is received may then be the reply to either.
        """
        del transaction, sent
        return False

    @abstractmethod
    def read(self, transaction: Transaction) -> Decoded:
        """Return the meaning of a transaction that has bytes."""

    def decoded(self, transaction: Transaction) -> Decoded:
        """Return the meaning of a transaction; cached once it is complete."""
        if (known := transaction.words) is not None:  # once: `forget` may come from another thread
            return known
        words = Decoded(transaction.note) if transaction.note else self.read(transaction)
        if transaction.is_over:
            transaction.words = words
        return words


class TransactionAssembler:
    """Builds transactions from the events of a line."""

    def __init__(self, decoder: Decoder) -> None:
        self._decoder = decoder
        self._count = 0
        self._settings: PortSettings | None = None
        self._echo: bool | None = None
        self._pending: Transaction | None = None

    def note_settings(self, settings: PortSettings, *, echo: bool) -> None:
        """Set what the session knows of the line better than the log, and whether it echoes."""
        self._settings, self._echo = settings, echo

    def forget_echo(self) -> None:
        """Reset what was known of the line: another one is opened."""
        self._echo = None

    def feed(self, events: Iterable[TrafficEvent]) -> list[Transaction]:
        """Take events; return every row that is new or has changed, in order."""
        touched: dict[int, Transaction] = {}

        def touch(transaction: Transaction | None) -> None:
            if transaction is not None:
                touched[transaction.number] = transaction

        for event in events:
            match event.way:
                case TrafficDirection.LINE:
                    touch(self._end())
                    self._settings = event.settings or self._settings
                    row = self._row(event.time)
                    row.note, row.is_over = event.text, True
                    touch(row)
                case TrafficDirection.SENT if self._pending and self._decoder.goes_with(
                    self._pending, event.data
                ):
                    self._pending.sent += event.data
                    touch(self._pending)
                case TrafficDirection.SENT:
                    touch(self._end())
                    self._pending = self._row(event.time, event.data)
                    touch(self._pending)
                case TrafficDirection.RECEIVED:
                    if self._pending is None or self._is_answered(self._pending):
                        touch(self._end())
                        self._pending = self._row(event.time)
                    self._pending.received += event.data
                    self._pending.ended = event.time
                    touch(self._pending)
        return [touched[number] for number in sorted(touched)]

    def _is_answered(self, transaction: Transaction) -> bool:
        return bool(transaction.received) and self._decoder.is_whole(transaction)

    def _end(self) -> Transaction | None:
        """Complete the pending row; return it."""
        ended, self._pending = self._pending, None
        if ended is not None:
            ended.is_over = True
        return ended

    def _row(self, time: float, sent: bytes = b"") -> Transaction:
        self._count += 1
        is_routine = bool(sent) and self._decoder.is_routine(sent)
        return Transaction(
            self._count,
            time,
            sent,
            settings=self._settings,
            echo=self._echo,
            is_routine=is_routine,
        )
