"""Error bits of a board, with the count and last time of their reports, and events for its log.

Reading a latched bit clears it, so every bit that was read is counted here. The board latches it
again for as long as its cause lasts.
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
    last: datetime | None = None  # date and time of the last report; `None` without one
    seen_at: float = -math.inf  # time of the last report on the monotonic clock, in seconds
    is_doubtful: bool = False  # the last report may be a corrupted reply
    is_uncleared: bool = False  # reported since the user cleared the errors
    is_earlier: bool = False  # latched before the connection, and not counted


def error_names(entries: Sequence[ErrorEntry]) -> str:
    """Return the names of errors, marked if all may come from corrupted replies."""
    names = ", ".join(tr(entry.name) for entry in entries)
    is_doubtful = all(entry.is_doubtful for entry in entries)
    return tr("{0} (doubtful)").format(names) if is_doubtful else names


_CHECK_LINE = tr_noop("Check cable and ground, and that no other program sends on this line.")

_STATUS_REMEDIES = {
    Status.MOTOR1_FAULT: DriveBlocker.FAULT.remedy,
    Status.MOTOR1_OVER_LIMIT: DriveBlocker.OVER_LIMIT.remedy,
    Status.MOTOR2_FAULT: DriveBlocker.FAULT.remedy,
    Status.MOTOR2_OVER_LIMIT: DriveBlocker.OVER_LIMIT.remedy,
    Status.UART_ERROR: _CHECK_LINE,
}
"""Remedy for each status bit, in the order in which the bits are shown."""

_UART_REMEDIES = {
    UartError.TIMEOUT: DriveBlocker.TIMEOUT.remedy,
    UartError.FORMAT: _CHECK_LINE,
    UartError.CRC: tr_noop(
        "Check cable and ground, and that every program on this line uses the same polynomial."
    ),
    UartError.FRAMING: tr_noop(
        "Check cable, ground and baud rate, and keep motor leads away from the line."
    ),
    UartError.DATA_OVERRUN: tr_noop("Use a lower baud rate."),
    UartError.PARITY: tr_noop(
        "Check cable and ground, and that every program on this line uses the same parity."
    ),
    UartError.READ_OVERRUN: tr_noop("Let no other program send on this line."),
    UartError.SEND_OVERRUN: tr_noop("Let other programs request fewer channels at once."),
}

UNSEEN = (
    *(ErrorEntry(bit, *STATUS_MEANING[bit], remedy) for bit, remedy in _STATUS_REMEDIES.items()),
    *(ErrorEntry(bit, *words, _UART_REMEDIES[bit]) for bit, words in UART_MEANING.items()),
)

ACTIVE_FOR = 1.0
"""Seconds after its last report for which an error is active: the status is read ten times a
second, and reports a lasting error each time."""


def is_latched(bit: Status | UartError, latched: LatchedStatus) -> bool:
    return bool(bit & (latched.status if isinstance(bit, Status) else latched.uart))


class ErrorCounts:
    """Counts and times of all status and UART error bits.

    Methods take the time in seconds of a monotonic clock.
    """

    def __init__(self, changed: Callable[[], None] = lambda: None) -> None:
        """`changed` is called when a bit was reported, and when errors were cleared or reset."""
        self.entries = UNSEEN  # motor 1, motor 2, then UART error and its kinds
        self._changed = changed
        self._others: dict[str, tuple[ErrorEntry, ...]] = {}  # entries of unselected boards

    @property
    def occurred(self) -> list[ErrorEntry]:
        """Errors that were reported, or latched before connecting, newest first.

        The bit that announces UART errors is left out if their kinds are listed.
        """
        found = [one for one in self.entries if one.count or one.is_earlier]
        details = [one for one in found if isinstance(one.bit, UartError)]
        return sorted(
            (
                one
                for one in found
                if one.bit is not Status.UART_ERROR
                or not any(detail.is_uncleared >= one.is_uncleared for detail in details)
            ),
            key=lambda one: -one.seen_at,
        )

    @staticmethod
    def is_active(entry: ErrorEntry, now: float) -> bool:
        return now - entry.seen_at < ACTIVE_FOR

    def recent(self, motor: int, now: float) -> list[ErrorEntry]:
        """Return the entries about motor 1 or 2 that are at most three seconds old.

        Serial timeouts and other UART errors are about both motors: they may have stopped them.
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
        """Count the bits of a status. `is_doubtful`: its reply may have been corrupted.

        Bits that were latched before the connection are only marked.
        """
        today = utc.astimezone()

        def taken(entry: ErrorEntry) -> ErrorEntry:
            if not is_latched(entry.bit, latched):
                return entry
            if latched.is_earlier:
                return replace(entry, is_earlier=True)
            return replace(
                entry,
                count=entry.count + 1,
                last=today,
                seen_at=now,
                is_doubtful=is_doubtful,
                is_uncleared=True,
            )

        self.entries = tuple(map(taken, self.entries))
        self._changed()

    def select(self, before: str, board: str) -> None:
        """Show the counts of another board on the line. Retain the counts of the board `before`."""
        self._others[before] = self.entries
        self.entries = self._others.pop(board, UNSEEN)
        self._changed()

    def clear(self, bit: Status | UartError) -> None:
        """Mark an error as known. Its count stays, and an active error is reported again."""
        other = Status.UART_ERROR if isinstance(bit, UartError) else bit
        self.entries = tuple(  # identity, since bits of both bytes have the same numbers
            replace(entry, is_uncleared=False) if entry.bit is bit or entry.bit is other else entry
            for entry in self.entries
        )
        self._changed()

    def reset(self) -> None:
        self.entries = UNSEEN
        self._changed()


# --- Events for the log -----------------------------------------------------------------

GOES_ON = 1.0  # seconds in which a repeated bit is one event: a fault repeats ten times a second

_KINDS = {
    **dict.fromkeys(MOTOR_FAULTS.values(), EventKind.FAULT),
    **dict.fromkeys(OVER_LIMITS.values(), EventKind.OVER_LIMIT),
}


class StatusEvents:
    """Creates events from latched bits. A bit that persists is one event."""

    def __init__(self) -> None:
        self._seen: dict[str, float] = {}

    def of(self, latched: LatchedStatus, before: Iterable[ErrorEntry]) -> Iterator[Event]:
        """Yield the events of a status. A serial error makes no new event until it is cleared."""
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
            elif not any(one.bit is error and one.is_uncleared for one in before):
                yield Event(latched.time, EventKind.LINK, tr(name), is_problem=True)

    def _of_bit(self, kind: EventKind, name: str, time: float) -> Iterator[Event]:
        before = self._seen.get(name)
        self._seen[name] = time
        if before is None or time - before > GOES_ON:
            yield Event(time, kind, tr(name), is_problem=True)


def _earlier(latched: LatchedStatus) -> Event:
    # The kinds of UART errors say more than the bit that announces them
    hidden = Status.UART_ERROR if latched.uart else None
    bits = [one for one in UNSEEN if is_latched(one.bit, latched) and one.bit is not hidden]
    text = tr("Latched before connecting, perhaps by the search for the board: {0}")
    return Event(latched.time, EventKind.LINK, text.format(", ".join(tr(one.name) for one in bits)))


def read_event(report: Connected, now: float) -> Event | None:
    """Return the event of a reading of the board. `None` if the user requested the reading."""
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
