"""Evidence that a board restarted while it drove motors."""

import math
from collections.abc import Sequence

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.board_reasons import NOISE_COUNTS
from trex_gui.devices.trex.driving.requests import SetMotor, Setpoint, is_idle
from trex_gui.devices.trex.driving.setpoints import LineQuality
from trex_gui.devices.trex.protocol.flags import Status, UartError

_DRAWING_COUNTS = 3  # minimum to confirm a current; inferred: an unloaded motor draws more
_SETTLING_SECONDS = 0.1  # time until the current follows a new setpoint

# Seconds without a current that indicate a restart. The motors of a robot that rolls downhill
# seldom lack a current for longer.
_FALL_SECONDS = 1.0
_FALL_SECONDS_AFTER_LOSS = 0.06  # after a lost reply


class RestartWatch:
    """Detects that a board restarted while it drove motors 1 and 2.

    No query reveals a restart, and a repeated setpoint would start a motor at rest. The evidence is
    a driven motor that stops drawing current on a quiet line, without an explanation in the status.
    A motor that never drew current is no evidence.
    """

    def __init__(self, quality: LineQuality) -> None:
        self._quality = quality
        self._running: dict[int, tuple[SetMotor, float]] = {}  # motor → setpoint, when settled
        self._drawing: set[int] = set()  # motors that drew a current
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
        """True if the board may have restarted. No speed may then be refreshed."""
        return bool(self._drawing) and (self._is_reply_lost or self._fallen_at < math.inf)

    def record_setpoints(self, setpoints: Sequence[Setpoint], now: float) -> None:
        for setpoint in setpoints:
            motor = setpoint.motor
            known, _ = self._running.get(motor, (None, now))
            if isinstance(setpoint, SetMotor) and motor in {1, 2} and setpoint != known:
                self._drawing.discard(motor)
                settled_at = math.inf if is_idle(setpoint) else now + _SETTLING_SECONDS
                self._running[motor] = setpoint, settled_at

    def record_lost_reply(self) -> None:
        """Record a failed transaction. Call this before `quality` counts the failure."""
        if self._quality.is_quiet and self._drawing:
            self._is_reply_lost = True

    def record_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        if (
            latched.status & ~Status.UART_ERROR
            or latched.uart & UartError.TIMEOUT
            or (stops_on_error and latched.has_line_error)
        ):
            self._drawing.clear()  # the status explains the missing current
            self._end_check()
        threshold = _FALL_SECONDS_AFTER_LOSS if self._is_reply_lost else _FALL_SECONDS
        self.has_restarted |= latched.is_whole and latched.time - self._fallen_at >= threshold

    def record_currents(self, counts: Sequence[int], now: float) -> None:
        if any(counts[motor - 1] > NOISE_COUNTS for motor in self._drawing):
            self._end_check()
        elif self._drawing and (self._quality.is_quiet or self._is_reply_lost):
            self._fallen_at = min(self._fallen_at, now)
        for motor, (_, settled_at) in self._running.items():
            if counts[motor - 1] >= _DRAWING_COUNTS and now >= settled_at:
                self._drawing.add(motor)
