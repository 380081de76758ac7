"""Queue, retry and refresh of setpoints, and the quality of the line."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.requests import (
    SetAuxiliary,
    SetMotor,
    Setpoint,
    SetpointRequest,
    is_idle,
    packets,
    setpoints_in,
)
from trex_gui.devices.trex.protocol.commands import Command, DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive

REPEATS = (0.15, 0.3, 0.6, 1.2)
"""Seconds before each retry of an unconfirmed setpoint.

Except on slow lines, the next status arrives before the first retry. A status with an error
restarts the sequence at once.
"""

MAX_RETRY_SECONDS = 5.0  # time after which no further retry is scheduled

_CLEAN_STATUSES = 2
"""Number of clean statuses, each after a packet, that confirm a setpoint. See `motor_driver`.

One status is enough if a retry could do harm. A speed without acceleration bypasses the current
limiter.
"""

_REFRESH_REPLIES = 1000  # consecutive undamaged replies after which refreshes end


class SetpointSlots:
    """Queue with one slot per motor. A new setpoint replaces the queued one."""

    def __init__(self) -> None:
        self._by_motor: dict[int, Setpoint] = {}
        self.clear = self._by_motor.clear

    def put(self, *requests: SetpointRequest) -> None:
        for request in requests:
            setpoints = setpoints_in(request)
            self._by_motor.update({setpoint.motor: setpoint for setpoint in setpoints})

    def __bool__(self) -> bool:
        return bool(self._by_motor)

    def pop(self) -> list[Setpoint]:
        setpoints = [self._by_motor[motor] for motor in sorted(self._by_motor)]
        self.clear()
        return setpoints

    def put_back(self, setpoints: Sequence[Setpoint]) -> None:
        self.put(*setpoints, *self.pop())  # queued setpoints are newer


class SetpointRetry:
    """Retries setpoints until clean statuses confirm them. Motor packets have no reply."""

    def __init__(self) -> None:
        self.due = math.inf  # time of the next retry, on the line's clock
        self._set_at = 0.0
        self._unconfirmed: list[Setpoint] = []
        self._repeated = 0
        self._clean = 0
        self._sent_since_status = False

    def start(self, setpoints: Sequence[Setpoint], now: float) -> None:
        slots = SetpointSlots()
        slots.put(*self._unconfirmed, *setpoints)
        self._set_at = now
        self._repeated = self._clean = 0
        self._schedule(slots.pop(), now)

    def pop_due(self, now: float) -> list[Setpoint]:
        setpoints = self._unconfirmed
        self._repeated += 1
        self._schedule(setpoints, now)
        return setpoints

    def clear(self) -> None:
        self._unconfirmed = []
        self.due = math.inf

    def _schedule(self, setpoints: list[Setpoint], now: float) -> None:
        is_late = now >= self._set_at + MAX_RETRY_SECONDS
        if is_late or self._repeated >= len(REPEATS):
            self.clear()
            return
        self._unconfirmed = setpoints
        self.due = now + REPEATS[self._repeated]
        self._sent_since_status = True

    def record_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        """Confirm the setpoints, or retry at once after an error.

        Motors that the board has stopped are not restarted.
        """
        if not self._unconfirmed:
            return
        if latched.stops_motors() or (stops_on_error and not latched.is_clean):
            self._unconfirmed = [setpoint for setpoint in self._unconfirmed if is_idle(setpoint)]
        if not latched.is_clean:
            self._clean = self._repeated = 0
            self.due = latched.time
        elif self._sent_since_status:
            self._sent_since_status = False
            self._clean += 1
        is_harmless = all(
            setpoint.accelerate or is_idle(setpoint) for setpoint in self._unconfirmed
        )
        if not self._unconfirmed or self._clean >= (_CLEAN_STATUSES if is_harmless else 1):
            self.clear()


QUIET = 300
"""Consecutive undamaged replies after which a line counts as quiet.

Assume that each byte is damaged with probability p, in one of its nine bits (eight data bits and
the stop bit). Damage to either of two bits turns the last brake of a motor into a speed without
being detected. The probability is 2p/9. Each reply needs an undamaged request byte, so the
probability of a damaged brake on a quiet line is below 2p/9 * (1 - p)**300. Its maximum is 2.7e-4
(p = 1/300). For p = 1 %, 2 % and 5 %, it is 1.1e-4, 1.0e-5 and 2e-9. The auxiliary speed has seven
such bits, so its probability is 3.5 times as high. CRC-7 detects every single-bit error. At 9600
baud and above, 300 replies take 2 s while risky polls are omitted.
"""


class LineQuality:
    """Record of damaged bytes on a line.

    A clean status means that the board latched no error, not that it received the packet as sent.
    Without a CRC, one flipped bit turns C0 7F (brake) into C2 7F (full speed forward), or 86 1F
    (a query) into C6 1F (a quarter forward). Such a line also damages bytes that are checked.
    """

    def __init__(self) -> None:
        self.replies = 0  # complete replies since the line was opened
        self.is_shared = False  # True while another process uses the line: failures do not count
        self._has_crc = False
        self._is_observed = False
        self._failures = 0
        self._damaged_at: int | None = None

    def observe(self, counters: Counters, *, has_crc: bool) -> None:
        self.replies = counters.replies
        self._has_crc = has_crc
        self._is_observed = True
        failures = counters.missing + counters.corrupted + counters.unsolicited
        if failures != self._failures:
            self._failures = failures
            self._record_damage()

    def record_status(self, latched: LatchedStatus) -> None:
        """Record latched line errors. Errors before the first `observe` are ignored."""
        if self._is_observed and latched.has_line_error:
            self._record_damage()

    @property
    def is_quiet(self) -> bool:
        """True if a clean status is sufficient confirmation."""
        return self.is_quiet_for(QUIET)

    def is_quiet_for(self, replies: int) -> bool:
        if self._has_crc or self._damaged_at is None:
            return True
        return self.replies - self._damaged_at >= replies

    def _record_damage(self) -> None:
        if not self.is_shared:
            self._damaged_at = self.replies


class SetpointRefresh:
    """Refreshes all setpoints on a line that damages bytes.

    Undetected damage can turn a setpoint or a query into another motor command. Detected damage
    makes this likely, so all setpoints are refreshed until the line is quiet. Speeds are sent as
    accelerate commands, which obey the current limiter. After the first setpoint or arming, motors
    without a setpoint are braked. Before that, nothing is sent, not even after a stop, because
    another program may drive the board.
    """

    def __init__(self, quality: LineQuality, may_have_restarted: Callable[[], bool]) -> None:
        self._quality = quality
        self._may_have_restarted = may_have_restarted
        self.stops_on_error = True  # True if the board stops its motors on a UART error
        self._is_active = False
        self._setpoints: dict[int, Setpoint] = {}
        self.clear = self._setpoints.clear  # motors without a setpoint count as braked
        self.holds_speeds = False  # True after the board has stopped motors, until a clean status
        self._auxiliary_at_risk = False
        self._quiet_since: int | None = None  # `LineQuality.replies` when the line became quiet
        self._sent_at = 0.0

    def record_setpoints(self, setpoints: Sequence[Setpoint], now: float) -> None:
        self._is_active = True
        self._sent_at = now
        self._setpoints.update({setpoint.motor: setpoint for setpoint in setpoints})
        if not all(isinstance(command, DriveMotor) for command in packets(setpoints)):
            self._record_auxiliary_risk()

    def record_stop(self, now: float, *, was_driven: bool) -> None:
        self.clear()
        self._is_active = self._is_active or was_driven
        self._sent_at = now
        self._record_auxiliary_risk()

    def record_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        """Hold back speeds after the board has stopped its motors, until a clean status."""
        self.stops_on_error = stops_on_error
        self.holds_speeds = latched.stops_motors(on_error=stops_on_error)
        if latched.uart and stops_on_error:  # a second reply confirms the error
            for setpoint in self.running:
                del self._setpoints[setpoint.motor]

    def on_armed(self) -> None:
        self._is_active = True

    def on_direct_command(self) -> None:
        """Pause until the next setpoint, stop or arming, since the motors' state is unknown."""
        self._is_active = False

    def due(self, interval: float) -> float:
        """Return the time of the next refresh, on the line's clock. Infinite on a quiet line."""
        if self._quality.is_quiet:
            self._watch_auxiliary()
        if self._quality.is_quiet_for(_REFRESH_REPLIES):
            return math.inf
        return self._sent_at + interval if self._is_active else math.inf

    def record_sent(self, now: float) -> None:
        self._sent_at = now

    def idle_commands(self) -> list[Command[None]]:
        """Return a packet for each idle motor.

        A packet for both motors is one bit away from a packet for the auxiliary motor, so each
        motor gets its own packet. The auxiliary motor gets a packet only if damage may have started
        it, since damage to its speed is dangerous.
        """
        motors = (self._setpoints.get(motor, SetMotor(motor, Drive.brake())) for motor in (1, 2))
        idle = [setpoint for setpoint in motors if is_idle(setpoint)]
        auxiliary = self._setpoints.get(SetAuxiliary.motor, SetAuxiliary(0))
        if self._auxiliary_at_risk and is_idle(auxiliary):
            self._record_auxiliary_risk()
            idle.append(auxiliary)
        return [command for setpoint in idle for command in packets([setpoint])]

    def speeds(self) -> list[Command[None]]:
        """Return a packet for each running motor. Empty if the board may have stopped motors.

        A board that may have restarted counts as stopped.
        """
        if self.holds_speeds or self._may_have_restarted():
            return []
        return [
            command
            for setpoint in self.running
            for command in packets([replace(setpoint, accelerate=True)])
        ]

    @property
    def running(self) -> list[Setpoint]:
        return [setpoint for setpoint in self._setpoints.values() if not is_idle(setpoint)]

    def _record_auxiliary_risk(self) -> None:
        self._auxiliary_at_risk = True
        self._quiet_since = None

    def _watch_auxiliary(self) -> None:
        if self._quiet_since is None:
            self._quiet_since = self._quality.replies
        if self._quality.replies - self._quiet_since >= QUIET:
            self._auxiliary_at_risk = False
