"""Question and answer put together again from the bytes of a line, whatever the device.

A row of a transcript is an `Transaction`: what was sent, what came until the next was sent, and
how long that took. What it means is the business of a `Decoder`, one for each device.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass

from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic_log import TrafficDirection, TrafficEvent


@dataclass(frozen=True, slots=True)
class Decoded:
    """What an exchange means, for people; `is_fault` where something went wrong in it."""

    text: str
    is_fault: bool = False


@dataclass(slots=True, eq=False)
class Transaction:
    """One row: something sent and its answer, or something that happened to the line.

    Attributes:
        number: counts the rows of a transcript, from 1.
        time: when it was sent; when the first byte came, where nothing was sent. Seconds on the
            line's clock.
        sent, received: the bytes; none of either where `note` says what happened to the line.
        ended: when the last byte had come, on the same clock; `None` while none has.
        settings: how the line was set.
        echo: whether everything sent comes back; `None` where nobody knows yet.
        is_routine: whether it is one of the questions that the program repeats all the time.
        is_over: whether nothing more will come.
        words: what it means, once somebody asked; see `Decoder.decoded`.
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
        """From the first byte handed over to the last one taken; `None`: no answer."""
        return None if self.ended is None or not self.sent else self.ended - self.time


class Decoder(ABC):
    """What the bytes of a device mean."""

    @abstractmethod
    def shown(self, data: bytes) -> str:
        """Return bytes as a person reads them: hexadecimal, or text."""

    @abstractmethod
    def is_routine(self, sent: bytes) -> bool:
        """Return whether the program repeats this question all the time."""

    @abstractmethod
    def is_whole(self, exchange: Transaction) -> bool:
        """Return whether the answer has come; what comes behind it belongs to nothing."""

    def goes_with(self, exchange: Transaction, sent: bytes) -> bool:
        """Return whether these bytes belong to the row that is open, though they were sent later.

        Whatever comes may be the answer to either then.
        """
        del exchange, sent
        return False

    @abstractmethod
    def read(self, exchange: Transaction) -> Decoded:
        """Return what an exchange means that has bytes."""

    def decoded(self, exchange: Transaction) -> Decoded:
        """Return what an exchange means; remembers it once the exchange is over."""
        if (known := exchange.words) is not None:  # once: `forget` may come from another thread
            return known
        words = Decoded(exchange.note) if exchange.note else self.read(exchange)
        if exchange.is_over:
            exchange.words = words
        return words


class TransactionAssembler:
    """Makes rows of pieces."""

    def __init__(self, wording: Decoder) -> None:
        self._wording = wording
        self._count = 0
        self._settings: PortSettings | None = None
        self._echo: bool | None = None
        self._open: Transaction | None = None

    def note_settings(self, settings: PortSettings, *, echo: bool) -> None:
        """Know better how the line is set than the line itself tells, and whether it echoes."""
        self._settings, self._echo = settings, echo

    def forget_echo(self) -> None:
        """Another line is opened."""
        self._echo = None

    def feed(self, pieces: Iterable[TrafficEvent]) -> list[Transaction]:
        """Take what has passed; return every row that is new or has changed, in order."""
        touched: dict[int, Transaction] = {}

        def touch(exchange: Transaction | None) -> None:
            if exchange is not None:
                touched[exchange.number] = exchange

        for piece in pieces:
            match piece.way:
                case TrafficDirection.LINE:
                    touch(self._end())
                    self._settings = piece.settings or self._settings
                    row = self._row(piece.time)
                    row.note, row.is_over = piece.text, True
                    touch(row)
                case TrafficDirection.SENT if self._open and self._wording.goes_with(
                    self._open, piece.data
                ):
                    self._open.sent += piece.data
                    touch(self._open)
                case TrafficDirection.SENT:
                    touch(self._end())
                    self._open = self._row(piece.time, piece.data)
                    touch(self._open)
                case TrafficDirection.RECEIVED:
                    if self._open is None or self._is_answered(self._open):
                        touch(self._end())
                        self._open = self._row(piece.time)
                    self._open.received += piece.data
                    self._open.ended = piece.time
                    touch(self._open)
        return [touched[number] for number in sorted(touched)]

    def _is_answered(self, exchange: Transaction) -> bool:
        return bool(exchange.received) and self._wording.is_whole(exchange)

    def _end(self) -> Transaction | None:
        """Let nothing more come to the row that is open; return it."""
        ended, self._open = self._open, None
        if ended is not None:
            ended.is_over = True
        return ended

    def _row(self, time: float, sent: bytes = b"") -> Transaction:
        self._count += 1
        is_routine = bool(sent) and self._wording.is_routine(sent)
        return Transaction(
            self._count,
            time,
            sent,
            settings=self._settings,
            echo=self._echo,
            is_routine=is_routine,
        )
