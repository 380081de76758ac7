"""Evidence that a board restarted while it drove motors."""

import math
from collections.abc import Sequence

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.board_reasons import NOISE_COUNTS
from trex_gui.devices.trex.driving.requests import SetMotor, Setpoint, is_idle
from trex_gui.devices.trex.driving.setpoints import LineQuality
from trex_gui.devices.trex.protocol.flags import Status, UartError

_DRAWS = 3  # counts that prove a current; inferred: a motor without load draws more
_SETTLING = 0.1  # seconds from a new setpoint to a current that belongs to it
_FALLEN = 1.0  # seconds without a current; a robot that rolls downhill seldom draws none for longer
_FALLEN_AFTER_LOSS = 0.06  # seconds without a current after a lost reply


class RestartWatch:
    """Finds out whether a board restarted while it drove motors 1 and 2.

    No query tells, and repeating a setpoint would start a motor that stands still. Evidence is that
    the motors that drew a current under their setpoints draw none any more, on a quiet line, with a
    status that gives no reason. Motors that never drew a current give no evidence.
    """

    def __init__(self, quality: LineQuality) -> None:
        self._quality = quality
        self._running: dict[int, tuple[SetMotor, float]] = {}  # and when it has settled
        self._drawing: set[int] = set()
        self.clear()

    def clear(self) -> None:
        self._running.clear()
        self._drawing.clear()
        self.has_restarted = False
        self._end_check()

    def _end_check(self) -> None:
        self._is_reply_lost = False
        self._fallen_at = math.inf

    @property
    def is_checking(self) -> bool:
        """True if the board may have restarted. No speed is refreshed meanwhile."""
        return bool(self._drawing) and (self._is_reply_lost or self._fallen_at < math.inf)

    def record_setpoints(self, setpoints: Sequence[Setpoint], now: float) -> None:
        for one in setpoints:
            known, _ = self._running.get(one.motor, (None, now))
            if isinstance(one, SetMotor) and one.motor in {1, 2} and one != known:
                self._drawing.discard(one.motor)
                self._running[one.motor] = one, math.inf if is_idle(one) else now + _SETTLING

    def record_lost_reply(self) -> None:
        """Record a failed transaction before `quality` counts it."""
        if self._quality.is_quiet and self._drawing:
            self._is_reply_lost = True

    def record_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        """Record a status, which may explain why no motor draws a current."""
        if (
            latched.status & ~Status.UART_ERROR
            or latched.uart & UartError.TIMEOUT
            or (stops_on_error and latched.has_line_error)
        ):
            self._drawing.clear()  # the status explains it
            self._end_check()
        enough = _FALLEN_AFTER_LOSS if self._is_reply_lost else _FALLEN
        self.has_restarted |= latched.is_whole and latched.time - self._fallen_at >= enough

    def record_currents(self, counts: Sequence[int], now: float) -> None:
        if any(counts[motor - 1] > NOISE_COUNTS for motor in self._drawing):
            self._end_check()
        elif self._drawing and (self._quality.is_quiet or self._is_reply_lost):
            self._fallen_at = min(self._fallen_at, now)
        for motor, (_, settled_at) in self._running.items():
            if counts[motor - 1] >= _DRAWS and now >= settled_at:
                self._drawing.add(motor)
