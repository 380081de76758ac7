"""Logs what happens to a board: stops, Apply, faults, lost and restored connections."""

from PySide6.QtCore import QObject, Slot

from trex_gui.core.session import Closed
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError
from trex_gui.devices.trex.session.messages import Connected, ReadReason
from trex_gui.ui.event_log import EventKind, EventLog

GOES_ON = 1.0
"""Seconds within which a repeated bit is the same event.

A fault that lasts latches its bit again right after each reading, ten times a second.
"""

_KINDS: dict[Status, EventKind] = {
    Status.MOTOR1_FAULT: EventKind.FAULT,
    Status.MOTOR2_FAULT: EventKind.FAULT,
    Status.MOTOR1_OVER_LIMIT: EventKind.OVER_LIMIT,
    Status.MOTOR2_OVER_LIMIT: EventKind.OVER_LIMIT,
}
_NAMED = 3
"""Written settings that an event names; the rest are counted."""


class EventWatch(QObject):
    """Adds to the event log of one board."""

    def __init__(
        self,
        events: EventLog,
        motors: Motors,
        connection: Connection,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._events = events
        self._motors = motors
        self._seen: dict[str, float] = {}
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
        self._events.add(EventKind.APPLY, self.tr("Apply: {0}").format(text))

    @Slot()
    def _on_stop_requested(self) -> None:
        reason = self._motors.stop_reason
        text = self.tr("Stop: {0}").format(reason) if reason else self.tr("Stop")
        self._events.add(EventKind.STOP, text)

    @Slot(object)
    def _on_read(self, report: Connected) -> None:
        match report.occasion:
            case ReadReason.OPENED:
                self._events.clear()
                self._seen.clear()
            case ReadReason.RETURNED:
                self._events.add(EventKind.LINK, self.tr("The board responds again"))
            case ReadReason.MODE_CHANGED:
                self._events.add(EventKind.LINK, self.tr("The board was switched off and on"))
            case ReadReason.RELOADED:
                pass

    @Slot()
    def _on_not_responding(self) -> None:
        self._events.add(EventKind.LINK, self.tr("The board stopped responding"))

    @Slot(object)
    def _on_closed(self, _last: Closed | None) -> None:
        self._events.add(EventKind.LINK, self.tr("Disconnected"))

    def note_status(self, latched: LatchedStatus) -> None:
        for bit, kind in _KINDS.items():
            if latched.status & bit:
                self._note_bit(kind, STATUS_MEANING[bit][0], latched.time)
        if latched.uart & UartError.TIMEOUT:
            self._note_bit(EventKind.TIMEOUT, UART_MEANING[UartError.TIMEOUT][0], latched.time)

    def _note_bit(self, kind: EventKind, name: str, time: float) -> None:
        before = self._seen.get(name)
        self._seen[name] = time
        if before is None or time - before > GOES_ON:
            self._events.add(kind, name, time)
