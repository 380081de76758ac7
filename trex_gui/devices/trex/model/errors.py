"""Every error bit that was ever seen: how often, and when last.

Reading a latched bit clears it, so every bit that was read is counted here.
"""

import math
from dataclasses import dataclass, replace
from datetime import UTC, datetime

from PySide6.QtCore import QObject, Signal

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError
from trex_gui.ui.runtime import now

Bit = Status | UartError


@dataclass(frozen=True, slots=True)
class ErrorEntry:
    """One bit and its history.

    Attributes:
        last: when it was seen last, by the calendar; `None` while it was never seen.
        seen_at: the same in seconds of the program's monotonic clock.
    """

    bit: Bit
    name: str
    meaning: str
    count: int = 0
    last: datetime | None = None
    seen_at: float = -math.inf


class ErrorLog(QObject):
    """Counts and times of all status and UART error bits.

    Signals:
        changed: a bit was seen, or everything was reset.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._entries = self._unseen()

    @property
    def entries(self) -> tuple[ErrorEntry, ...]:
        """Status bits, then UART error bits, highest bit first."""
        return tuple(self._entries)

    def recent(self, motor: int, seconds: float = 3.0) -> list[ErrorEntry]:
        """Return what concerns motor 1 or 2 and was seen within the last `seconds`.

        Serial timeouts and other UART errors concern both: they may have shut it down.
        """
        since = now() - seconds
        of_motor = {
            1: Status.MOTOR1_FAULT | Status.MOTOR1_OVER_LIMIT,
            2: Status.MOTOR2_FAULT | Status.MOTOR2_OVER_LIMIT,
        }[motor]
        return [
            entry
            for entry in self._entries
            if entry.seen_at > since and (isinstance(entry.bit, UartError) or entry.bit & of_motor)
        ]

    def take(self, news: LatchedStatus) -> None:
        """Count the bits of one look at the status."""
        today = datetime.now(UTC).astimezone()
        for index, entry in enumerate(self._entries):
            seen = news.status if isinstance(entry.bit, Status) else news.uart
            if seen & entry.bit:
                self._entries[index] = replace(
                    entry, count=entry.count + 1, last=today, seen_at=now()
                )
        self.changed.emit()

    def reset(self) -> None:
        """Set every count to zero."""
        self._entries = self._unseen()
        self.changed.emit()

    @staticmethod
    def _unseen() -> list[ErrorEntry]:
        # A list: bits of the two bytes are equal numbers and would share keys of a table.
        status = [ErrorEntry(bit, *words) for bit, words in STATUS_MEANING.items()]
        uart = [ErrorEntry(bit, *words) for bit, words in UART_MEANING.items()]
        return [*status, *uart]
