"""Stops, Apply, faults, and lost and restored connections of one board."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Slot

from trex_gui.core.session import Closed
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.errors import UNSEEN, is_latched
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError
from trex_gui.devices.trex.session.messages import Connected, ReadReason
from trex_gui.ui.event_log import EventKind, EventLog
from trex_gui.ui.runtime import now

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
            text = tr("{0} and {1} more").format(text, len(done) - _NAMED)
        if failed:
            text = tr("{0} ({1} failed)").format(text, failed).strip()
        self.add(EventKind.APPLY, tr("Apply: {0}").format(text), is_problem=failed > 0)

    @Slot()
    def _on_stop_requested(self) -> None:
        reason = self._motors.stop_reason
        text = tr("Stop: {0}").format(reason) if reason else tr("Stop")
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
                text = tr("Connected to {0} on {1}.")
                self.add(
                    EventKind.LINK,
                    text.format(report.state.signature, report.settings.text()),
                )
            case ReadReason.RETURNED:
                self.returns += 1
                self.add(EventKind.LINK, tr("The board responds again"))
            case ReadReason.RESTARTED:
                self.restarts += 1
                self.add(EventKind.LINK, tr("The board was switched off and on"))
            case ReadReason.SETTING_CHANGED:
                text = tr(
                    "A setting changed: the board was restarted, or another program wrote to it"
                )
                self.add(EventKind.LINK, text, is_problem=True)
            case ReadReason.SELECTED:
                text = tr("Device {0} selected: {1}")
                number = report.settings.device_number
                self.add(EventKind.LINK, text.format(number, report.state.signature))
            case ReadReason.RELOADED:
                pass

    @Slot()
    def _on_not_responding(self) -> None:
        self.add(EventKind.LINK, tr("The board stopped responding"), is_problem=True)

    @Slot(object)
    def _on_closed(self, last: Closed | None) -> None:
        self.connected_at = None
        if self._was_read:
            self._was_read = False
            may_move = last is not None and last.may_move
            text = tr("Disconnected")
            if may_move:
                text = tr("Disconnected before a stop was confirmed: motors may still turn")
            self.add(EventKind.LINK, text, is_problem=may_move)

    def note_status(self, latched: LatchedStatus) -> None:
        if latched.is_earlier:
            bits = [entry for entry in UNSEEN if is_latched(entry.bit, latched)]
            # The kinds of UART errors say more than that there was one.
            has_kinds = bool(latched.uart)
            names = [tr(e.name) for e in bits if not (has_kinds and e.bit is Status.UART_ERROR)]
            text = tr("Latched before connecting, perhaps by the search for the board: {0}")
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
