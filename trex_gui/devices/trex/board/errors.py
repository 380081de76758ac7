"""Error bits of a board: counts, times and log events.

Reading a latched bit clears it. Inferred: the board latches the bit again while its
cause persists.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from trex_gui.core.events import Event, EventKind
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.protocol.flags import (
    MOTOR_FAULTS,
    OVER_LIMITS,
    STATUS_MEANING,
    UART_MEANING,
    Status,
    UartError,
)
from trex_gui.devices.trex.session.messages import Connected, ReadReason


@dataclass(frozen=True, slots=True)
class ErrorEntry:
    bit: Status | UartError
    name: str
    meaning: str
    remedy: str
    count: int = 0
    last: datetime | None = None  # local date and time of the last report
    seen_at: float = -math.inf  # time of the last report on the monotonic clock, in seconds
    is_doubtful: bool = False  # True if the last report may be a corrupted reply
    is_uncleared: bool = False  # True if reported since the user last cleared the error
    is_earlier: bool = False  # True if latched before the connection, which is not counted


def error_names(entries: Sequence[ErrorEntry]) -> str:
    """Return the names of errors, marked if all of them are doubtful."""
    names = ", ".join(tr(entry.name) for entry in entries)
    is_doubtful = all(entry.is_doubtful for entry in entries)
    return tr("{0} (doubtful)").format(names) if is_doubtful else names


_CHECK_LINE = tr_noop(
    "Check the cable and the ground connection, and make sure that no "
    "other program sends on this line."
)

_STATUS_REMEDIES = {  # in display order
    Status.MOTOR1_FAULT: DriveBlocker.FAULT.remedy,
    Status.MOTOR1_OVER_LIMIT: DriveBlocker.OVER_LIMIT.remedy,
    Status.MOTOR2_FAULT: DriveBlocker.FAULT.remedy,
    Status.MOTOR2_OVER_LIMIT: DriveBlocker.OVER_LIMIT.remedy,
    Status.UART_ERROR: _CHECK_LINE,
}

_UART_REMEDIES = {
    UartError.TIMEOUT: DriveBlocker.TIMEOUT.remedy,
    UartError.FORMAT: _CHECK_LINE,
    UartError.CRC: tr_noop(
        "Check the cable and the ground connection, and make sure that every program on this "
        "line uses the same polynomial."
    ),
    UartError.FRAMING: tr_noop(
        "Check the cable, the ground connection and the baud rate, and keep motor leads away "
        "from the cable."
    ),
    UartError.DATA_OVERRUN: tr_noop("Use a lower baud rate."),
    UartError.PARITY: tr_noop(
        "Check the cable and the ground connection, and make sure that every program on this "
        "line uses the same parity."
    ),
    UartError.READ_OVERRUN: tr_noop("Make sure that no other program sends on this line."),
    UartError.SEND_OVERRUN: tr_noop("Make other programs request fewer channels at once."),
}

UNSEEN = (
    *(ErrorEntry(bit, *STATUS_MEANING[bit], remedy) for bit, remedy in _STATUS_REMEDIES.items()),
    *(ErrorEntry(bit, *words, _UART_REMEDIES[bit]) for bit, words in UART_MEANING.items()),
)

# The status is read ten times a second. Each reading reports all persistent errors.
ACTIVE_FOR = 1.0  # seconds after its last report for which an error counts as active


def is_latched(bit: Status | UartError, latched: LatchedStatus) -> bool:
    return bool(bit & (latched.status if isinstance(bit, Status) else latched.uart))


class ErrorCounts:
    """Counts and times of all status and UART error bits.

    `now` is in seconds of a monotonic clock.
    """

    def __init__(self, changed: Callable[[], None] = lambda: None) -> None:
        self.entries = UNSEEN  # motor 1, motor 2, then UART error and its kinds
        self._changed = changed
        self._others: dict[str, tuple[ErrorEntry, ...]] = {}  # entries of unselected boards

    @property
    def occurred(self) -> list[ErrorEntry]:
        """Errors that were reported, or latched before the connection. Newest first.

        Specific UART errors replace the general bit, unless only the general bit is uncleared.
        """
        entries = [entry for entry in self.entries if entry.count or entry.is_earlier]
        specific = [entry for entry in entries if isinstance(entry.bit, UartError)]
        return sorted(
            (
                entry
                for entry in entries
                if entry.bit is not Status.UART_ERROR
                or not any(error.is_uncleared >= entry.is_uncleared for error in specific)
            ),
            key=lambda entry: -entry.seen_at,
        )

    @staticmethod
    def is_active(entry: ErrorEntry, now: float) -> bool:
        return now - entry.seen_at < ACTIVE_FOR

    def recent(self, motor: int, now: float) -> list[ErrorEntry]:
        """Return the errors of a motor from the last three seconds.

        UART errors count for both motors, because they may stop both motors.
        """
        of_motor = MOTOR_FAULTS[motor] | OVER_LIMITS[motor]
        return [
            entry
            for entry in self.entries
            if entry.seen_at > now - 3.0
            and (isinstance(entry.bit, UartError) or entry.bit & of_motor)
        ]

    def count(
        self, latched: LatchedStatus, now: float, utc: datetime, *, is_doubtful: bool = False
    ) -> None:
        """Count the bits of a status.

        Bits that were latched before the connection are marked, but not counted. `is_doubtful`
        means that the reply may be corrupted.
        """
        local_time = utc.astimezone()

        def counted(entry: ErrorEntry) -> ErrorEntry:
            if not is_latched(entry.bit, latched):
                return entry
            if latched.is_earlier:
                return replace(entry, is_earlier=True)
            return replace(
                entry,
                count=entry.count + 1,
                last=local_time,
                seen_at=now,
                is_doubtful=is_doubtful,
                is_uncleared=True,
            )

        self.entries = tuple(map(counted, self.entries))
        self._changed()

    def select(self, before: str, board: str) -> None:
        """Switch from the counts of `before` to the counts of `board`."""
        self._others[before] = self.entries
        self.entries = self._others.pop(board, UNSEEN)
        self._changed()

    def clear(self, bit: Status | UartError) -> None:
        """Mark an error as cleared. An active error is reported again.

        A specific UART error also clears the general UART error bit.
        """
        general_bit = Status.UART_ERROR if isinstance(bit, UartError) else bit
        self.entries = tuple(  # compare by identity: bits of the two bytes have equal values
            replace(entry, is_uncleared=False)
            if entry.bit is bit or entry.bit is general_bit
            else entry
            for entry in self.entries
        )
        self._changed()

    def reset(self) -> None:
        self.entries = UNSEEN
        self._changed()


# --- Events for the log -----------------------------------------------------------------

_EVENT_GAP = 1.0  # seconds; a bit that is reported again after a longer gap causes a new event

_KINDS = {
    **dict.fromkeys(MOTOR_FAULTS.values(), EventKind.FAULT),
    **dict.fromkeys(OVER_LIMITS.values(), EventKind.OVER_LIMIT),
}


class StatusEvents:
    """Log events for latched bits. A persistent bit causes one event."""

    def __init__(self) -> None:
        self._seen: dict[str, float] = {}

    def of(self, latched: LatchedStatus, before: Iterable[ErrorEntry]) -> Iterator[Event]:
        """Yield the events of a status.

        An uncleared serial error causes no new event, unless it is a timeout.
        """
        if latched.is_earlier:
            yield _earlier(latched)
            return
        for bit, kind in _KINDS.items():
            if latched.status & bit:
                yield from self._of_bit(kind, STATUS_MEANING[bit][0], latched.time)
        for error in latched.uart:
            name = UART_MEANING[error][0]
            if error is UartError.TIMEOUT:
                yield from self._of_bit(EventKind.TIMEOUT, name, latched.time)
            elif not any(entry.bit is error and entry.is_uncleared for entry in before):
                yield Event(latched.time, EventKind.LINK, tr(name), is_problem=True)

    def _of_bit(self, kind: EventKind, name: str, time: float) -> Iterator[Event]:
        before = self._seen.get(name)
        self._seen[name] = time
        if before is None or time - before > _EVENT_GAP:
            yield Event(time, kind, tr(name), is_problem=True)


def _earlier(latched: LatchedStatus) -> Event:
    # Specific UART errors replace the general bit.
    hidden = Status.UART_ERROR if latched.uart else None
    names = ", ".join(
        tr(entry.name)
        for entry in UNSEEN
        if is_latched(entry.bit, latched) and entry.bit is not hidden
    )
    text = tr("Latched before connecting, perhaps by a search for the board: {0}")
    return Event(latched.time, EventKind.LINK, text.format(names))


def connected_event(report: Connected, now: float) -> Event | None:
    is_problem = report.occasion is ReadReason.SETTING_CHANGED
    match report.occasion:
        case ReadReason.OPENED:
            text = tr("Connected to {0} on {1}.")
            text = text.format(report.state.signature, report.settings.text())
        case ReadReason.RETURNED:
            text = tr("The board responds again")
        case ReadReason.RESTARTED:
            text = tr("The board was switched off and on")
        case ReadReason.SETTING_CHANGED:
            text = tr("A setting changed: the board was restarted, or another program wrote to it")
        case ReadReason.SELECTED:
            text = tr("Device {0} selected: {1}")
            text = text.format(report.settings.device_number, report.state.signature)
        case _:
            return None
    return Event(now, EventKind.LINK, text, is_problem)
