"""What went over a device's line: the newest rows, for a page and for a file."""

import time
from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.transactions import Decoded, Decoder, Transaction, TransactionAssembler
from trex_gui.ui.runtime import now, runtime
from trex_gui.ui.workers.session_thread import SessionThread

MOST_KEPT = 20_000
"""Rows of each shelf; at full telemetry those of all bytes reach back for less than a minute."""

_TRIMMED = MOST_KEPT * 9 // 10
_INTERVAL_MS = 100


class Shelf:
    """The newest rows of one kind, oldest first, and how many went before them."""

    def __init__(self) -> None:
        self._rows: list[Transaction] = []
        self._gone = 0

    @property
    def rows(self) -> Sequence[Transaction]:
        """What is kept."""
        return self._rows

    @property
    def count(self) -> int:
        """How many rows there ever were."""
        return self._gone + len(self._rows)

    def since(self, count: int) -> Sequence[Transaction]:
        """Return the rows behind the first `count`, as far as they are kept."""
        return self._rows[max(count - self._gone, 0) :]

    def add(self, transaction: Transaction) -> None:
        """Add a row; the oldest go, many at a time."""
        self._rows.append(transaction)
        if len(self._rows) > MOST_KEPT:
            self._gone += len(self._rows) - _TRIMMED
            del self._rows[:-_TRIMMED]

    def clear(self) -> None:
        """Forget all."""
        self._rows.clear()
        self._gone = 0


class TrafficModel(QObject):
    """Reads the tape of a session thread a few times a second while there is a line.

    Two shelves: on one lies everything, on the other what is not polled all the time, and what
    went wrong with that; so a write of ten minutes ago is not pushed out by telemetry.

    Signals:
        changed: there are more rows, or the last one has more bytes.
        cleared: all were forgotten.

    Attributes:
        everything: the newest rows.
        without_polling: the newest ones that are not just polling.
        faults: how many rows went wrong since the last `clear`.
    """

    changed = Signal()
    cleared = Signal()

    def __init__(self, line: SessionThread, decoder: Decoder) -> None:
        super().__init__(line)
        self.everything = Shelf()
        self.without_polling = Shelf()
        self.faults = 0
        self._log = line.log
        self._decoder = decoder
        self._assembler = TransactionAssembler(decoder)
        self._newest = 0
        self._epoch = time.time() - now()
        self._timer = runtime().timer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self.pull)
        line.started.connect(self._on_started)
        line.closed.connect(self._on_closed)

    @property
    def lost(self) -> int:
        """Pieces that were never read, because the window stood still for too long."""
        return self._log.lost

    def note_settings(self, settings: PortSettings, *, echo: bool) -> None:
        """Know how the line is set, where the device has said more than the port knows."""
        self.pull()
        self._assembler.note_settings(settings, echo=echo)

    def forget_words(self) -> None:
        """Say everything anew: more is known of the device."""
        for transaction in self.everything.rows:
            transaction.words = None
        for transaction in self.without_polling.rows:
            transaction.words = None
        self.changed.emit()

    def decoded(self, transaction: Transaction) -> Decoded:
        """Return what a row means."""
        return self._decoder.decoded(transaction)

    def shown(self, data: bytes) -> str:
        """Return bytes as a person reads them."""
        return self._decoder.shown(data)

    def wall_time(self, transaction: Transaction) -> float:
        """Return when a row was, in seconds since 1970."""
        return self._epoch + transaction.time

    def clear(self) -> None:
        """Forget every row."""
        self.pull()
        self.everything.clear()
        self.without_polling.clear()
        self.faults = 0
        self.cleared.emit()

    @Slot()
    def pull(self) -> None:
        """Read what was noted."""
        rows = self._assembler.feed(self._log.take())
        for transaction in rows:
            self._put_away(transaction)
        if rows:
            self.changed.emit()

    def _put_away(self, transaction: Transaction) -> None:
        is_new = transaction.number > self._newest
        if is_new:
            self._newest = transaction.number
            self.everything.add(transaction)
        is_fault = transaction.is_over and self.decoded(transaction).is_fault
        self.faults += is_fault
        if is_fault if transaction.is_routine else is_new:
            self.without_polling.add(transaction)

    @Slot()
    def _on_started(self) -> None:
        self._epoch = time.time() - now()
        self._assembler.forget_echo()
        self._timer.start()

    @Slot()
    def _on_closed(self) -> None:
        self._timer.stop()
        self.pull()
