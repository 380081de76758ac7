"""Every error bit: how often it was reported, and when last.

Reading a latched bit clears it, so every bit that was read is counted here.
"""

import math
from dataclasses import dataclass, replace
from datetime import UTC, datetime

from PySide6.QtCore import QObject, Signal

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError
from trex_gui.ui.runtime import now

_OF_MOTOR = {
    1: Status.MOTOR1_FAULT | Status.MOTOR1_OVER_LIMIT,
    2: Status.MOTOR2_FAULT | Status.MOTOR2_OVER_LIMIT,
}


@dataclass(frozen=True, slots=True)
class ErrorEntry:
    """One bit and its history.

    Attributes:
        last: date and time of the last report; `None` without one.
        seen_at: the same in seconds of the program's monotonic clock.
    """

    bit: Status | UartError
    name: str
    meaning: str
    count: int = 0
    last: datetime | None = None
    seen_at: float = -math.inf


_UNSEEN = (
    *(ErrorEntry(bit, *words) for bit, words in STATUS_MEANING.items()),
    *(ErrorEntry(bit, *words) for bit, words in UART_MEANING.items()),
)


class ErrorLog(QObject):
    """Counts and times of all status and UART error bits.

    Signals:
        changed: a bit was reported, or everything was reset.

    Attributes:
        entries: status bits, then UART error bits, highest bit first.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.entries = _UNSEEN

    def recent(self, motor: int, seconds: float = 3.0) -> list[ErrorEntry]:
        """Return the entries about motor 1 or 2 that are at most `seconds` old.

        Serial timeouts and other UART errors concern both: they may have shut it down.
        """
        since = now() - seconds
        return [
            entry
            for entry in self.entries
            if entry.seen_at > since
            and (isinstance(entry.bit, UartError) or entry.bit & _OF_MOTOR[motor])
        ]

    def take(self, latched: LatchedStatus) -> None:
        """Count the bits of one status report."""
        today = datetime.now(UTC).astimezone()
        self.entries = tuple(
            replace(entry, count=entry.count + 1, last=today, seen_at=now())
            if entry.bit & (latched.status if isinstance(entry.bit, Status) else latched.uart)
            else entry
            for entry in self.entries
        )
        self.changed.emit()

    def reset(self) -> None:
        """Set every count to zero."""
        self.entries = _UNSEEN
        self.changed.emit()
