"""Events of a board, as its log shows them."""

from collections.abc import Iterable, Iterator

from trex_gui.core.events import Event, EventKind
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.errors import UNSEEN, ErrorEntry, is_latched
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError
from trex_gui.devices.trex.session.messages import Connected, ReadReason

GOES_ON = 1.0  # seconds in which a repeated bit is one event: a fault repeats ten times a second

_KINDS: dict[Status, EventKind] = {
    Status.MOTOR1_FAULT: EventKind.FAULT,
    Status.MOTOR2_FAULT: EventKind.FAULT,
    Status.MOTOR1_OVER_LIMIT: EventKind.OVER_LIMIT,
    Status.MOTOR2_OVER_LIMIT: EventKind.OVER_LIMIT,
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
    bits = [entry for entry in UNSEEN if is_latched(entry.bit, latched)]
    # The kinds of UART errors say more than the bit that announces them.
    has_kinds = bool(latched.uart)
    names = [tr(e.name) for e in bits if not (has_kinds and e.bit is Status.UART_ERROR)]
    text = tr("Latched before connecting, perhaps by the search for the board: {0}")
    return Event(latched.time, EventKind.LINK, text.format(", ".join(names)))


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
