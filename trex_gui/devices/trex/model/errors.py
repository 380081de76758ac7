"""Events of a board, and every error bit: how often it was reported, and when last.

Reading a latched bit clears it, so every bit that was read is counted here. The board latches it
again for as long as its cause lasts.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.session import Closed
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError
from trex_gui.devices.trex.session.messages import Connected, ReadReason
from trex_gui.ui.event_log import EventKind, EventLog
from trex_gui.ui.runtime import now

_OF_MOTOR = {
    1: Status.MOTOR1_FAULT | Status.MOTOR1_OVER_LIMIT,
    2: Status.MOTOR2_FAULT | Status.MOTOR2_OVER_LIMIT,
}


@dataclass(frozen=True, slots=True)
class ErrorEntry:
    """One bit and its history."""

    bit: Status | UartError
    name: str
    meaning: str
    remedy: str
    count: int = 0
    last: datetime | None = None  # date and time of the last report; `None` without one
    seen_at: float = -math.inf  # the same in seconds of the program's monotonic clock
    is_doubtful: bool = False  # the last report may be a corrupted reply
    is_uncleared: bool = False  # reported since the user cleared the errors
    is_earlier: bool = False  # latched before the connection, which is not counted


_STATUS_REMEDIES = {
    Status.MOTOR1_FAULT: DriveBlocker.FAULT.remedy,
    Status.MOTOR1_OVER_LIMIT: DriveBlocker.OVER_LIMIT.remedy,
    Status.MOTOR2_FAULT: DriveBlocker.FAULT.remedy,
    Status.MOTOR2_OVER_LIMIT: DriveBlocker.OVER_LIMIT.remedy,
    Status.UART_ERROR: tr_noop("See the rows below."),
}
"""What to do about each status bit, in the order in which the bits are shown."""

_UART_REMEDIES = {
    UartError.TIMEOUT: DriveBlocker.TIMEOUT.remedy,
    UartError.FORMAT: tr_noop(
        "Check cable and ground, and that no other program sends on this line.",
    ),
    UartError.CRC: tr_noop(
        "Check cable and ground, and that every program on this line uses the same polynomial.",
    ),
    UartError.FRAMING: tr_noop(
        "Check cable, ground and baud rate, and keep motor leads away from the line.",
    ),
    UartError.DATA_OVERRUN: tr_noop("Use a lower baud rate."),
    UartError.PARITY: tr_noop(
        "Check cable and ground, and that every program on this line uses the same parity.",
    ),
    UartError.READ_OVERRUN: tr_noop("Let no other program send on this line."),
    UartError.SEND_OVERRUN: tr_noop("Let other programs request fewer channels at once."),
}

_UNSEEN = (
    *(ErrorEntry(bit, *STATUS_MEANING[bit], remedy) for bit, remedy in _STATUS_REMEDIES.items()),
    *(ErrorEntry(bit, *words, _UART_REMEDIES[bit]) for bit, words in UART_MEANING.items()),
)

ACTIVE_FOR = 1.0
"""Seconds after its last report for which an error is active: the status is read ten times a
second, and again and again says what lasts."""


def is_latched(bit: Status | UartError, latched: LatchedStatus) -> bool:
    return bool(bit & (latched.status if isinstance(bit, Status) else latched.uart))


class ErrorLog(QObject):
    """Counts and times of all status and UART error bits."""

    changed = Signal()  # a bit was reported, or the errors were cleared or reset

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.entries = _UNSEEN  # of motor 1, of motor 2, UART error and its kinds
        self._others: dict[str, tuple[ErrorEntry, ...]] = {}  # of boards that are not selected

    @property
    def uncleared(self) -> int:
        """How many kinds of errors were reported since they were cleared.

        The bit that announces UART errors does not count beside them.
        """
        bits = [one.bit for one in self.entries if one.is_uncleared]
        has_details = any(isinstance(bit, UartError) for bit in bits)
        return sum(not (has_details and bit is Status.UART_ERROR) for bit in bits)

    @staticmethod
    def is_active(entry: ErrorEntry) -> bool:
        return now() - entry.seen_at < ACTIVE_FOR

    def recent(self, motor: int) -> list[ErrorEntry]:
        """Return the entries about motor 1 or 2 that are at most three seconds old.

        Serial timeouts and other UART errors concern both: they may have shut it down.
        """
        since = now() - 3.0
        return [
            entry
            for entry in self.entries
            if entry.seen_at > since
            and (isinstance(entry.bit, UartError) or entry.bit & _OF_MOTOR[motor])
        ]

    def take(self, latched: LatchedStatus, *, is_doubtful: bool = False) -> None:
        """Count the bits of a status; `is_doubtful`: its reply may have been corrupted.

        Bits that are older than the connection are only noted.
        """
        today = datetime.now(UTC).astimezone()

        def taken(entry: ErrorEntry) -> ErrorEntry:
            if not is_latched(entry.bit, latched):
                return entry
            if latched.is_earlier:
                return replace(entry, is_earlier=True)
            return replace(
                entry,
                count=entry.count + 1,
                last=today,
                seen_at=now(),
                is_doubtful=is_doubtful,
                is_uncleared=True,
            )

        self.entries = tuple(map(taken, self.entries))
        self.changed.emit()

    def select(self, before: str, board: str) -> None:
        """Show the counts of another board on the line; keep those of the one `before`."""
        self._others[before] = self.entries
        self.entries = self._others.pop(board, _UNSEEN)
        self.changed.emit()

    def clear(self) -> None:
        """Take the errors as known; counts stay, and what is still active is reported again."""
        self.entries = tuple(replace(entry, is_uncleared=False) for entry in self.entries)
        self.changed.emit()

    def reset(self) -> None:
        """Forget every count and time, too."""
        self.entries = _UNSEEN
        self.changed.emit()


GOES_ON = 1.0  # seconds in which a repeated bit is one event: a fault repeats ten a second

_KINDS: dict[Status, EventKind] = {
    Status.MOTOR1_FAULT: EventKind.FAULT,
    Status.MOTOR2_FAULT: EventKind.FAULT,
    Status.MOTOR1_OVER_LIMIT: EventKind.OVER_LIMIT,
    Status.MOTOR2_OVER_LIMIT: EventKind.OVER_LIMIT,
}
_NAMED = 3  # written settings that an event names; the rest are counted


class BoardEvents(EventLog):
    """Stops, Apply, faults, and lost and restored connections of one board."""

    def __init__(
        self,
        motors: Motors,
        connection: Connection,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = now,
    ) -> None:
        super().__init__(parent, clock=clock)
        self._motors = motors
        self._seen: dict[str, float] = {}
        self._was_read = False  # since the line was opened
        self.connected_at: float | None = None  # on `clock`; `None` while no board is connected
        self.restarts = 0  # how often the board was seen to have restarted since then
        self.returns = 0  # how often it responded again after it was silent
        motors.stop_requested.connect(self._on_stop_requested)
        connection.device_read.connect(self._on_read)
        connection.not_responding.connect(self._on_not_responding)
        connection.line_closed.connect(self._on_closed)

    def note_applied(self, results: tuple[WriteResult, ...], names: tuple[str, ...]) -> None:
        """Log what Apply has written; `names` are those of `results`."""
        done = [name for name, one in zip(names, results, strict=True) if one.error is None]
        failed = len(results) - len(done)
        text = ", ".join(done[:_NAMED])
        if len(done) > _NAMED:
            text = self.tr("{0} and {1} more").format(text, len(done) - _NAMED)
        if failed:
            text = self.tr("{0} ({1} failed)").format(text, failed).strip()
        self.add(EventKind.APPLY, self.tr("Apply: {0}").format(text), is_problem=failed > 0)

    @Slot()
    def _on_stop_requested(self) -> None:
        reason = self._motors.stop_reason
        text = self.tr("Stop: {0}").format(reason) if reason else self.tr("Stop")
        self.add(EventKind.STOP, text)

    @Slot(object)
    def _on_read(self, report: Connected) -> None:
        match report.occasion:
            case ReadReason.OPENED:
                self.clear()
                self._seen.clear()
                self._was_read = True
                self.connected_at = self._clock()
                self.restarts = self.returns = 0
                text = self.tr("Connected to {0} on {1}.")
                self.add(
                    EventKind.LINK,
                    text.format(report.state.signature, report.settings.text()),
                )
            case ReadReason.RETURNED:
                self.returns += 1
                self.add(EventKind.LINK, self.tr("The board responds again"))
            case ReadReason.RESTARTED:
                self.restarts += 1
                self.add(EventKind.LINK, self.tr("The board was switched off and on"))
            case ReadReason.SETTING_CHANGED:
                text = self.tr(
                    "A setting changed: the board was restarted, or another program wrote to it"
                )
                self.add(EventKind.LINK, text, is_problem=True)
            case ReadReason.SELECTED:
                text = self.tr("Device {0} selected: {1}")
                number = report.settings.device_number
                self.add(EventKind.LINK, text.format(number, report.state.signature))
            case ReadReason.RELOADED:
                pass

    @Slot()
    def _on_not_responding(self) -> None:
        self.add(EventKind.LINK, self.tr("The board stopped responding"), is_problem=True)

    @Slot(object)
    def _on_closed(self, last: Closed | None) -> None:
        self.connected_at = None
        if self._was_read:
            self._was_read = False
            may_move = last is not None and last.may_move
            text = self.tr("Disconnected")
            if may_move:
                text = self.tr("Disconnected before a stop was confirmed: motors may still turn")
            self.add(EventKind.LINK, text, is_problem=may_move)

    def note_status(self, latched: LatchedStatus) -> None:
        if latched.is_earlier:
            bits = [entry for entry in _UNSEEN if is_latched(entry.bit, latched)]
            # The kinds of UART errors say more than that there was one.
            has_kinds = bool(latched.uart)
            names = [tr(e.name) for e in bits if not (has_kinds and e.bit is Status.UART_ERROR)]
            text = self.tr("Latched before connecting, perhaps by the search for the board: {0}")
            self.add(EventKind.LINK, text.format(", ".join(names)), latched.time)
            return
        for bit, kind in _KINDS.items():
            if latched.status & bit:
                self._note_bit(kind, STATUS_MEANING[bit][0], latched.time)
        if latched.uart & UartError.TIMEOUT:
            self._note_bit(EventKind.TIMEOUT, UART_MEANING[UartError.TIMEOUT][0], latched.time)

    def _note_bit(self, kind: EventKind, name: str, time: float) -> None:
        before = self._seen.get(name)
        self._seen[name] = time
        if before is None or time - before > GOES_ON:
            self.add(kind, tr(name), time, is_problem=True)
