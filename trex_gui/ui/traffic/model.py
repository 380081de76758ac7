"""Newest transactions on a serial line."""

import itertools
import time
from collections.abc import Callable, Sequence
from typing import TextIO

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.transport import transcript
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic import Decoder, TrafficLog, Transaction, TransactionAssembler
from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.workers.file_worker import ProgressCallback
from trex_gui.ui.workers.session_thread import SessionThread

MAX_ROWS = 20_000  # per buffer; less than a minute of full telemetry
_REPORTED = 2000  # rows per buffer in a support report

_CHUNK = 100  # rows written between two progress reports
_TRIMMED = MAX_ROWS * 9 // 10  # rows that remain when a full buffer drops its oldest rows
_INTERVAL_MS = 100  # interval between two readings of the log


class RowBuffer:
    """Newest rows of one kind, oldest first."""

    def __init__(self) -> None:
        self.rows: list[Transaction] = []
        self._dropped = 0

    @property
    def count(self) -> int:
        """Number of rows added since the last `clear`."""
        return self._dropped + len(self.rows)

    def since(self, count: int) -> Sequence[Transaction]:
        """Return the rows that were added after the first `count` rows."""
        return self.rows[max(count - self._dropped, 0) :]

    def add(self, transaction: Transaction) -> None:
        self.rows.append(transaction)
        if len(self.rows) > MAX_ROWS:
            self._dropped += len(self.rows) - _TRIMMED
            del self.rows[:-_TRIMMED]

    def clear(self) -> None:
        self.rows.clear()
        self._dropped = 0


class TrafficModel(QObject):
    """Transactions of a session thread.

    Telemetry soon displaces all other rows, so a second buffer omits successful polls.
    """

    changed = Signal()  # new rows, or new bytes in the last row
    cleared = Signal()

    def __init__(self, line: SessionThread, decoder: Decoder) -> None:
        super().__init__(line)
        self.everything = RowBuffer()
        self.without_polling = RowBuffer()  # without successful polls
        self.faults = 0  # number of faulty rows since the last `clear`
        self.log = line.log
        self.decoder = decoder
        numbers = itertools.count(1)
        self._assembler = TransactionAssembler(decoder, numbers=numbers)
        self.search_log = TrafficLog()  # traffic of device scans
        self._search = TransactionAssembler(decoder, numbers=numbers, is_search=True)
        self._typed: list[bytes] = []  # typed requests that have no row yet
        self._newest = 0  # number of the newest row
        self._epoch = time.time() - now()  # wall time at 0 on the session's clock
        self._is_open = self._is_searching = False
        self._timer = new_timer(self, _INTERVAL_MS, self.pull)
        line.started.connect(self._on_started)
        line.closed.connect(self._on_closed)

    def record_settings(self, settings: PortSettings, *, echo: bool) -> None:
        self.pull()
        self._assembler.settings, self._assembler.echo = settings, echo

    def expect_typed(self, data: bytes) -> None:
        """Show the next request with these bytes, even if it looks like a poll."""
        self._typed.append(data)

    def decode_again(self) -> None:
        """Decode all rows again. Call this after a change of the decoder's state."""
        for transaction in (*self.everything.rows, *self.without_polling.rows):
            transaction.cached_meaning = None
        self.changed.emit()

    def wall_time(self, transaction: Transaction) -> float:
        return self._epoch + transaction.time

    def line_of(self, row: Transaction) -> str:
        """Return a row as tab-separated text without a newline."""
        return transcript.line_of(row, self.decoder, self._epoch)

    def newest_as_text(self) -> Callable[[], str]:
        """Return a thread-safe function that returns the newest rows as text."""
        self.pull()
        rows = {
            row.number: row
            for buffer in (self.without_polling, self.everything)
            for row in buffer.rows[-_REPORTED:]
        }

        def text() -> str:
            lines = [self.line_of(rows[number]) for number in sorted(rows)]
            return transcript.header() + "".join(f"{line}\n" for line in lines)

        return text

    def write(
        self, file: TextIO, progress: ProgressCallback, *, rows: Sequence[Transaction]
    ) -> int:
        """Write rows as tab-separated text. Return the number of rows. Thread-safe."""
        file.write(transcript.header())
        for done, row in enumerate(rows):
            if done % _CHUNK == 0:
                progress(done / len(rows))
            file.write(f"{self.line_of(row)}\n")
        return len(rows)

    def clear(self) -> None:
        self.pull()
        self.everything.clear()
        self.without_polling.clear()
        self.faults = 0
        self.cleared.emit()

    @Slot()
    def pull(self) -> None:
        rows = self._assembler.feed(self.log.pop())
        rows += self._search.feed(self.search_log.pop())
        for transaction in rows:
            self._add(transaction)
        if rows:
            self.changed.emit()

    def _add(self, transaction: Transaction) -> None:
        is_new = transaction.number > self._newest
        if is_new:
            self._newest = transaction.number
            self.everything.add(transaction)
            if transaction.sent in self._typed:
                self._typed.remove(transaction.sent)
                transaction.is_routine = False
        is_fault = (
            transaction.is_over and not transaction.is_search and self.decoder.is_fault(transaction)
        )
        self.faults += is_fault
        is_hidden = transaction.is_routine and not transaction.is_search
        if is_fault if is_hidden else is_new:
            self.without_polling.add(transaction)

    @Slot()
    def _on_started(self) -> None:
        self._epoch = time.time() - now()
        self._assembler.echo = None
        self._typed.clear()
        self._is_open = True
        self._update_timer()

    @Slot()
    def _on_closed(self) -> None:
        self._is_open = False
        self._update_timer()

    def set_searching(self, searching: bool) -> None:
        """Set whether a scan fills `search_log`."""
        self._is_searching = searching
        self._update_timer()

    def _update_timer(self) -> None:
        """Read the logs while a session or a scan fills them."""
        is_filling = self._is_open or self._is_searching
        if is_filling and not self._timer.isActive():
            self._timer.start()
        elif not is_filling:
            self._timer.stop()
            self.pull()
