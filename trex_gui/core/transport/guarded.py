"""Transport under the supervision of a guardian."""

import contextlib
from collections.abc import Callable

from trex_gui.core.errors import BadReply, NoReply, PortUnavailable
from trex_gui.core.guardian.guardian import HEARTBEAT_INTERVAL, StopSequence
from trex_gui.core.translation import tr
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import SerialFormat

_READY_S = 1.0  # timeout in seconds for the start of a guardian

_REPLACE_S = 0.4  # if a lost guardian is not replaced in this time (s), the motors are stopped

_SHORT_TIMEOUT_S = 0.2
"""Seconds to wait for a reply even if a stop is due.

The board does not listen while it replies, and a late reply could be mistaken for the next
reply."""

_LAST_STOP_S = 0.4  # timeout in seconds of the guardian's stop on a lost line


class GuardedTransport:
    """Sends heartbeats to the guardian while the session uses the line.

    After `silence` seconds without a heartbeat, the guardian may have stopped the motors and may
    still use the line. Before the session uses the line again, the guardian is replaced. Then
    `taken_over` is called with True if the guardian has confirmed the stop, otherwise with False.
    Until the session has sent a stop, any other write raises `NoReply`, because the data may
    contain an old setpoint.

    If a lost guardian is not replaced in time while motors may move, `taken_over` is called with
    `None`. In this case, too, the session must send a stop.

    While motors may move, a read ends early if a stop is due.

    Args:
        below: the line.
        silence: see `Timeouts.guardian`.
        stop_sequence: returns the current stop, or `None` if no motor can be moving.
        taken_over: called in the thread of the session. Must not use the line.
        stop_is_due: returns whether the session must stop the motors.
    """

    def __init__(
        self,
        below: Transport,
        silence: float,
        stop_sequence: Callable[[], StopSequence | None],
        *,
        taken_over: Callable[[bool | None], None],
        stop_is_due: Callable[[], bool],
    ) -> None:
        self._below = below
        self._silence = silence
        self._stop_sequence = stop_sequence
        self._taken_over = taken_over
        self._stop_is_due = stop_is_due
        self._sequence: StopSequence | None = None
        self._beat_at = below.clock()
        self._guardian = below.start_guardian(silence)
        self._ready_by: float | None = None  # time by which a replacement guardian must be ready
        self._was_ready = self._guardian_stops = False
        self._stop_to_send = b""  # must be written before anything else
        # Called during a read with the elapsed time (s). Returns the seconds until the next call.
        # The function may write.
        self.while_waiting: Callable[[float], float] = lambda _seconds: HEARTBEAT_INTERVAL
        self.rates = below.rates
        self.clock = below.clock
        self.start_guardian = below.start_guardian
        self.latency = below.latency
        self.is_configurable = below.is_configurable

    @property
    def is_guarded(self) -> bool:
        """True if a guardian is ready or a replacement is starting."""
        return self._guardian.is_ready or (self._was_ready and self._ready_by is not None)

    def wait_for_guardian(self) -> None:
        self._guardian.wait_until_ready(_READY_S)
        self._was_ready = self._was_ready or self._guardian.is_ready

    @property
    def _has_taken_over(self) -> bool:
        is_late = self._sequence is not None and self.clock() - self._beat_at >= self._silence
        return is_late or self._guardian.has_acted

    def beat(self) -> None:
        """Send a heartbeat if it is due. Reclaim the line if the guardian has taken it over."""
        if self._has_taken_over:
            self._reclaim_line()
            return
        sequence = self._stop_sequence()
        self._replace_lost_guardian(sequence)
        now = self.clock()
        if sequence is None and self._sequence is None:
            return
        if sequence != self._sequence or now - self._beat_at >= HEARTBEAT_INTERVAL:
            self._guardian.watch(sequence)
            self._sequence = sequence
            self._beat_at = now

    def _replace_lost_guardian(self, sequence: StopSequence | None) -> None:
        """Replace a lost guardian. If no replacement is ready in time, require a stop."""
        if self._guardian.is_ready:
            self._was_ready, self._ready_by = True, None
        elif self._was_ready and self._ready_by is None:
            self._restart(_REPLACE_S)
        elif self._was_ready and self.clock() >= (self._ready_by or 0.0):
            self._was_ready = False
            if sequence is not None:
                self._stop_to_send = sequence.packets
                self._taken_over(None)

    def _reclaim_line(self) -> None:
        self._stop_to_send = self._sequence.packets if self._sequence is not None else b""
        confirmed = self._guardian.end()
        self._restart(_READY_S)
        self._taken_over(confirmed)
        with contextlib.suppress(BadReply):
            self._below.discard()  # replies to the guardian

    def _restart(self, seconds: float) -> None:
        self._guardian.end()
        self._guardian = self._below.start_guardian(self._silence)
        self._sequence = None
        self._beat_at = self.clock()
        self._ready_by = self._beat_at + seconds

    def reconfigure(self, line: SerialFormat) -> None:
        self.beat()
        self._below.reconfigure(line)

    def write(self, data: bytes) -> None:
        self.beat()
        if self._stop_to_send and data not in self._stop_to_send:
            raise NoReply(tr("Stop the motors first."))
        self._stop_to_send = b""
        self._below.write(data)

    def read(self, size: int, seconds: float) -> bytes:
        started = self.clock()
        deadline = started + seconds
        received = b""
        while True:
            self.beat()
            remaining = min(deadline - self.clock(), self.while_waiting(self.clock() - started))
            try:
                received += self._below.read(size - len(received), remaining)
            except PortUnavailable:
                if not self._has_taken_over:  # the guardian may have read these bytes
                    raise
            now = self.clock()
            if len(received) >= size or now >= deadline:
                return received
            if (
                self._sequence is not None
                and now - started >= _SHORT_TIMEOUT_S
                and self._stop_is_due()
            ):
                return received

    def discard(self) -> bytes:
        self.beat()
        return self._below.discard()

    def wait(self, seconds: float) -> None:
        end = self.clock() + seconds
        while (remaining := end - self.clock()) > 0:
            self.beat()
            self._below.wait(min(remaining, HEARTBEAT_INTERVAL))

    def stop_by_guardian(self) -> bool:
        """Request a stop from the guardian. Return whether the stop was confirmed."""
        self._guardian_stops = True
        return self._guardian.stop(_LAST_STOP_S)

    def close(self) -> None:
        """Close the line. A guardian that is stopping the motors continues to do so."""
        if not self._guardian.has_acted and not self._guardian_stops:
            self._guardian.end()
        self._below.close()
