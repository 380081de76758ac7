"""Queued, unconfirmed and refreshed setpoints, and the quality of the line that carries them."""

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
"""Seconds after which an unconfirmed setpoint is sent again, one after the other.

The first is later than the next status on all but slow lines. After a status with an error the
sequence begins again, at once.
"""

LONGEST_REPEATING = 5.0  # seconds after which a setpoint is repeated no more, confirmed or not

_CLEAN_STATUSES = 2
"""Packets and clean statuses, in turn, that confirm a setpoint; see `motor_driver`.

One where a repeat could do harm: setting a speed at once bypasses the current limiter.
"""

_REFRESHED = 1000  # replies without damage after which setpoints are not refreshed any more

_MOTORS = (1, 2)


class SetpointSlots:
    """One slot for each motor: a newer setpoint replaces the queued one."""

    def __init__(self) -> None:
        self._by_motor: dict[int, Setpoint] = {}
        self.clear = self._by_motor.clear

    def put(self, *requests: SetpointRequest) -> None:
        for request in requests:
            self._by_motor.update({one.motor: one for one in setpoints_in(request)})

    def __bool__(self) -> bool:
        return bool(self._by_motor)

    def take(self) -> list[Setpoint]:
        """Return the setpoints, motors first, and clear the slots."""
        setpoints = [self._by_motor[motor] for motor in sorted(self._by_motor)]
        self.clear()
        return setpoints

    def put_back(self, setpoints: Sequence[Setpoint]) -> None:
        """Queue setpoints of corrupted packets again, unless newer ones are queued."""
        self.put(*setpoints, *self.take())


class SetpointRetry:
    """Sends unconfirmed setpoints again until a status confirms them.

    Motor packets have no reply: a clean status that was read after one confirms it.
    """

    def __init__(self) -> None:
        self.due = math.inf  # when to send them again, on the line's clock
        self._set_at = 0.0
        self._unconfirmed: list[Setpoint] = []
        self._repeated = 0
        self._clean = 0
        self._sent_since_status = False

    def begin(self, setpoints: Sequence[Setpoint], now: float) -> None:
        """Note setpoints that are sent for the first time."""
        slots = SetpointSlots()
        slots.put(*self._unconfirmed, *setpoints)
        self._set_at = now
        self._repeated = self._clean = 0
        self._schedule(slots.take(), now)

    def take(self, now: float) -> list[Setpoint]:
        """Return the unconfirmed setpoints, and count them as sent."""
        setpoints = self._unconfirmed
        self._repeated += 1
        self._schedule(setpoints, now)
        return setpoints

    def clear(self) -> None:
        self._unconfirmed = []
        self.due = math.inf

    def _schedule(self, setpoints: list[Setpoint], now: float) -> None:
        is_late = now >= self._set_at + LONGEST_REPEATING
        if is_late or self._repeated >= len(REPEATS):
            self.clear()
            return
        self._unconfirmed = setpoints
        self.due = now + REPEATS[self._repeated]
        self._sent_since_status = True

    def note_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        """Confirm the setpoints, or schedule them at once after an error.

        Motors that the board has stopped are not started again. `stops_on_error`: the board stops
        its motors on a UART error.
        """
        if not self._unconfirmed:
            return
        if latched.stops_motors() or (stops_on_error and not latched.is_clean):
            self._unconfirmed = [one for one in self._unconfirmed if is_idle(one)]
        if not latched.is_clean:
            self._clean = self._repeated = 0
            self.due = latched.time
        elif self._sent_since_status:
            self._sent_since_status = False
            self._clean += 1
        is_harmless = all(one.accelerate or is_idle(one) for one in self._unconfirmed)
        if not self._unconfirmed or self._clean >= (_CLEAN_STATUSES if is_harmless else 1):
            self.clear()


QUIET = 300
"""Whole replies in a row without damage after which a line counts as quiet.

If each byte is damaged with probability p, in any of its bits, the last packet of a brake drives
that motor with 2p/9 (two of the eight data bits and the stop bit), undetected. Each reply needs at
least one undamaged byte of ours, so the probability that such a line counts as quiet is less than
2p/9 * (1 - p)**300: at most 2.7e-4 (where p is 1/300), 1.1e-4 at 1 %, 1.0e-5 at 2 %, 2e-9 at 5 %.
The speed of the auxiliary motor has seven such bits: 3.5 times that. CRC-7 detects every single
bit. At 19200 baud and above 300 replies take 1.6 s.
"""


class LineQuality:
    """Whether a line has been undamaged long enough to trust a clean status.

    A clean status confirms that the board latched no error, not that it received the packet that
    was sent: without a CRC, one bit makes C0 7F (brake) into C2 7F (full speed forward), or 86 1F
    (a query) into C6 1F (a quarter forward). But such a line damages other bytes too, which shows.
    """

    def __init__(self) -> None:
        self.answers = 0  # whole replies since the line was opened
        # Whether another process uses the line too: what fails meanwhile is no damage
        self.is_shared = False
        self._has_crc = False
        self._is_observed = False
        self._failures = 0
        self._damaged_at: int | None = None

    def observe(self, counters: Counters, *, has_crc: bool) -> None:
        """Take the counters of the client, which show failed transactions."""
        self.answers = counters.replies
        self._has_crc = has_crc
        self._is_observed = True
        failures = counters.missing + counters.corrupted + counters.unsolicited
        if failures != self._failures:
            self._failures = failures
            self._note_damage()

    def note_status(self, latched: LatchedStatus) -> None:
        """Take the line errors that the board has latched.

        Before the first `observe` they are older than the connection.
        """
        if self._is_observed and latched.has_line_error:
            self._note_damage()

    @property
    def is_quiet(self) -> bool:
        """Whether a clean status is sufficient confirmation."""
        return self.is_quiet_for(QUIET)

    def is_quiet_for(self, replies: int) -> bool:
        """Whether the line has a CRC, or was not damaged while these replies came."""
        if self._has_crc or self._damaged_at is None:
            return True
        return self.answers - self._damaged_at >= replies

    def _note_damage(self) -> None:
        if not self.is_shared:
            self._damaged_at = self.answers


class SetpointRefresh:
    """Sends every setpoint again and again on a line that damages bytes.

    Undetected damage can turn a motor another way: its own packet, or a query, arrives as another
    motor command. Only other damage shows that, so setpoints go out until the line is quiet, speeds
    as accelerate commands, which the current limiter limits. Motors that were never driven are
    idle and braked from the first setpoint or arming on. Before that nothing is sent, also after a
    stop: another program may drive the board.
    """

    def __init__(self, quality: LineQuality, holds_speeds: Callable[[], bool]) -> None:
        self._quality = quality
        self._is_held = holds_speeds
        self.stops_on_error = True  # whether the board stops its motors on a UART error
        self._is_active = False
        self._setpoints: dict[int, Setpoint] = {}
        self.clear = self._setpoints.clear  # takes every motor for idle, braked fully
        self.holds_speeds = False  # until the next clean status: the board has stopped motors
        self._auxiliary_at_risk = False
        self._answers_since: int | None = None
        self._sent_at = 0.0

    def note_setpoints(self, setpoints: Sequence[Setpoint], now: float) -> None:
        self._is_active = True
        self._sent_at = now
        self._setpoints.update({one.motor: one for one in setpoints})
        if not all(isinstance(command, DriveMotor) for command in packets(setpoints)):
            self._note_auxiliary_risk()

    def note_stop(self, now: float, *, was_driven: bool) -> None:
        self.clear()
        self._is_active = self._is_active or was_driven
        self._sent_at = now
        self._note_auxiliary_risk()

    def note_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        """Hold speeds until the next clean status if the board has stopped motors."""
        self.stops_on_error = stops_on_error
        self.holds_speeds = latched.stops_motors(on_error=stops_on_error)
        if latched.uart and stops_on_error:  # no bit that noise added
            for setpoint in self.running:
                del self._setpoints[setpoint.motor]

    def on_direct_command(self) -> None:
        """Send nothing until the next setpoint or stop: it is not known which motors are idle."""
        self._is_active = False

    def due(self, interval: float, *, armed: bool) -> float:
        """Return when to send, on the line's clock; never while the line is quiet."""
        self._is_active = self._is_active or armed
        if self._quality.is_quiet:
            self._watch_auxiliary()
        if self._quality.is_quiet_for(_REFRESHED):
            return math.inf
        return self._sent_at + interval if self._is_active else math.inf

    def note_sent(self, now: float) -> None:
        """Note that everything was sent again, which takes a while where echoes are awaited."""
        self._sent_at = now

    def take_idle(self) -> list[Command[None]]:
        """Return the packets of every idle motor.

        One each: the packet for both motors is one bit away from one for the auxiliary motor.
        The auxiliary motor is left out unless an earlier packet may have started it: damage to
        any bit of the speed makes its own packet more dangerous than none.
        """
        motors = (self._setpoints.get(one, SetMotor(one, Drive.brake())) for one in _MOTORS)
        idle = [one for one in motors if is_idle(one)]
        auxiliary = self._setpoints.get(SetAuxiliary.motor, SetAuxiliary(0))
        if self._auxiliary_at_risk and is_idle(auxiliary):
            self._note_auxiliary_risk()
            idle.append(auxiliary)
        return [command for setpoint in idle for command in packets([setpoint])]

    def speeds(self) -> list[Command[None]]:
        """Return the packets of every motor that runs, as far as the status shows."""
        running = [] if self.holds_speeds or self._is_held() else self.running
        return [each for one in running for each in packets([replace(one, accelerate=True)])]

    @property
    def running(self) -> list[Setpoint]:
        return [one for one in self._setpoints.values() if not is_idle(one)]

    def _note_auxiliary_risk(self) -> None:
        """Note a packet that damage can turn into a speed of the auxiliary motor."""
        self._auxiliary_at_risk = True
        self._answers_since = None

    def _watch_auxiliary(self) -> None:
        """End the risk when the line has been quiet after that packet."""
        if self._answers_since is None:
            self._answers_since = self._quality.answers
        if self._quality.answers - self._answers_since >= QUIET:
            self._auxiliary_at_risk = False
