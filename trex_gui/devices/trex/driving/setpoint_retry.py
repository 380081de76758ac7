"""A wish that was sent is sent again until a status proves that it has arrived.

Motor packets have no reply: a status that was read after one, and is clean, is the proof.
"""

from collections.abc import Sequence

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.idle_refresh import is_idle
from trex_gui.devices.trex.driving.setpoints import SetpointSlots
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.session.messages import SetAuxiliary, SetMotor

REPEATS = (0.15, 0.3, 0.6, 1.2)
"""Seconds after which what stands is sent once more, one after the other, until it is proved.

The first is later than the next status of a line that is not slow; where none comes, they become
rare. A status with an error begins anew, at once.
"""

LONGEST_REPEATING = 5.0
"""Seconds after the newest wish from which on it is not repeated any more, proved or not."""

_ROUNDS = 2
"""Packets and clean statuses, one after the other, that prove a wish; see `stopping`.

One does where a repeat could do harm: setting a speed at once goes round the current limiter.
"""

_SHUT_DOWN = Status.MOTOR1_FAULT | Status.MOTOR2_FAULT
"""What the status says when the board has stopped a motor itself."""


class SetpointRetry:
    """The newest wish for each motor that was sent and is not proved.

    Attributes:
        due: when it is to be sent again, on the line's clock; `None`: not.
    """

    def __init__(self) -> None:
        self.due: float | None = None
        self._wished_at = 0.0
        self._standing = SetpointSlots()
        self._repeated = 0
        self._proofs = 0
        self._unseen = False

    def begin(self, wishes: Sequence[SetMotor | SetAuxiliary], now: float) -> None:
        """These are being sent for the first time."""
        self._wished_at = now
        self._repeated = self._proofs = 0
        self._stand(wishes, now)

    def take(self, now: float) -> list[SetMotor | SetAuxiliary]:
        """Return what is to be sent again, and count it as sent."""
        wishes = self._standing.take()
        self._repeated += 1
        self._stand(wishes, now)
        return wishes

    def rest(self) -> None:
        """Repeat nothing any more."""
        self._standing.clear()
        self.due = None

    def _stand(self, wishes: Sequence[SetMotor | SetAuxiliary], now: float) -> None:
        is_late = now >= self._wished_at + LONGEST_REPEATING
        if is_late or self._repeated >= len(REPEATS):
            self.rest()
            return
        self._standing.put_all(wishes)
        self.due = now + REPEATS[self._repeated]
        self._unseen = True

    def note_status(
        self, news: LatchedStatus | None, now: float, *, is_whole: bool, stops_on_error: bool
    ) -> None:
        """Learn from a status that was read: whether what stands has arrived, or must go again.

        `is_whole` says that no error can be waiting behind it, `stops_on_error` that the board
        stops its motors on any. What it has stopped itself is not started again.
        """
        if self.due is None:
            return
        status = Status(0) if news is None else news.status
        uart = UartError(0) if news is None else news.uart
        is_clean = is_whole and (news is None or not news.has_line_error)
        wishes = self._standing.take()
        if status & _SHUT_DOWN or uart & UartError.TIMEOUT or (stops_on_error and not is_clean):
            wishes = [wish for wish in wishes if is_idle(wish)]
        if is_clean and self._unseen:
            self._unseen = False
            self._proofs += 1
        elif not is_clean:
            self._proofs = self._repeated = 0
            self.due = now
        is_harmless = all(wish.accelerate or is_idle(wish) for wish in wishes)
        if not wishes or self._proofs >= (_ROUNDS if is_harmless else 1):
            self.rest()
        else:
            self._standing.put_all(wishes)
