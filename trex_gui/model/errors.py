"""Every error bit that was ever seen: how often, and when last.

The board latches a bit until somebody reads it, and reading clears it; so whoever reads owns
the news, and nothing of it may be lost.
"""

from dataclasses import dataclass, replace
from datetime import UTC, datetime

from PySide6.QtCore import QObject, Signal

from trex_gui.link.telemetry import StatusNews
from trex_gui.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError

Bit = Status | UartError


@dataclass(frozen=True, slots=True)
class ErrorEntry:
    """One bit and its history; `last` is `None` while it was never seen."""

    bit: Bit
    name: str
    meaning: str
    count: int = 0
    last: datetime | None = None


class ErrorLog(QObject):
    """Counts and times of all status and UART error bits.

    Signals:
        changed: a bit was seen, or everything was reset.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._entries: dict[Bit, ErrorEntry] = {}
        self._fill()

    @property
    def entries(self) -> tuple[ErrorEntry, ...]:
        """Status bits, then UART error bits, highest bit first."""
        return tuple(self._entries.values())

    def take(self, news: StatusNews) -> None:
        """Count the bits of one look at the status."""
        now = datetime.now(UTC).astimezone()
        for bit, entry in self._entries.items():
            seen = news.status if isinstance(bit, Status) else news.uart
            if seen & bit:
                self._entries[bit] = replace(entry, count=entry.count + 1, last=now)
        self.changed.emit()

    def reset(self) -> None:
        """Set every count to zero."""
        self._fill()
        self.changed.emit()

    def _fill(self) -> None:
        self._entries = {}
        for table in (STATUS_MEANING, UART_MEANING):
            for bit, (name, meaning) in table.items():
                self._entries[bit] = ErrorEntry(bit, name, meaning)
