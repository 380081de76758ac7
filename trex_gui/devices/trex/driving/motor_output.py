"""State machine of the motor output.

It does no I/O. `motor_driver` sends the packets. `now` is the time in seconds on the line's clock.
`Arming` and `Motion` change independently, with separate transition tables.
"""

import logging
import math
from collections.abc import Callable, Mapping, Sequence
from enum import Enum, auto

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.requests import (
    Arm,
    CommandsRepeated,
    Heartbeat,
    MotorReport,
    MotorRequest,
    MotorsStopped,
    Setpoint,
    Stop,
    is_valid,
)
from trex_gui.devices.trex.driving.restart import RestartWatch
from trex_gui.devices.trex.driving.setpoints import (
    LineQuality,
    SetpointRefresh,
    SetpointRetry,
    SetpointSlots,
)
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexNoReplyError

log = logging.getLogger(__name__)

STOP_RETRY_INTERVAL = 0.25  # seconds between retries of an unconfirmed stop


class Arming(Enum):
    """Motor commands that may be sent."""

    INITIAL = auto()  # all commands: the motors have been neither armed nor stopped yet
    ARMED = auto()  # all commands while heartbeats arrive
    DISARMED = auto()  # no commands until the motors are armed
    UNREACHABLE = auto()  # neither commands nor arming: the board does not respond


class Motion(Enum):
    """Motion of the motors, inferred from commands and confirmations."""

    STOPPED = auto()  # no motor was driven since the last confirmed stop
    DRIVEN = auto()  # a motor may be moving as commanded
    STOP_UNCONFIRMED = auto()  # a motor may be moving after a stop, which is retried


class OutputEvent(Enum):
    ARM = auto()
    STOP = auto()
    NOT_RESPONDING = auto()
    BOARD_READ = auto()
    SETPOINT_SENT = auto()
    DIRECT_COMMAND_SENT = auto()
    STOP_CONFIRMED = auto()
    STOP_CLEAN_BUT_NOISY = auto()  # clean statuses followed the stop, but the line damages bytes
    STOP_NOT_ANSWERED = auto()


class Action(Enum):
    START_WATCHDOG = auto()  # and allow refreshes
    DROP_SETPOINTS = auto()  # drop queued, unconfirmed and refreshed setpoints
    FAIL_NOISY_STOPS = auto()  # report the stops that wait for a quiet line as unconfirmed
    CONFIRM_NOISY_STOPS = auto()


_ARM = (Action.START_WATCHDOG,)
_DROP = (Action.DROP_SETPOINTS,)
_CONFIRM = (Action.CONFIRM_NOISY_STOPS,)
_FAIL = (Action.FAIL_NOISY_STOPS,)
_UNREACHABLE = (*_DROP, *_FAIL)

_ARMING: Mapping[tuple[Arming, OutputEvent], tuple[Arming, tuple[Action, ...]]] = {
    (Arming.INITIAL, OutputEvent.ARM): (Arming.ARMED, _ARM),
    (Arming.INITIAL, OutputEvent.STOP): (Arming.DISARMED, _DROP),
    (Arming.INITIAL, OutputEvent.NOT_RESPONDING): (Arming.UNREACHABLE, _UNREACHABLE),
    (Arming.ARMED, OutputEvent.ARM): (Arming.ARMED, _ARM),
    (Arming.ARMED, OutputEvent.STOP): (Arming.DISARMED, _DROP),
    (Arming.ARMED, OutputEvent.NOT_RESPONDING): (Arming.UNREACHABLE, _UNREACHABLE),
    (Arming.DISARMED, OutputEvent.ARM): (Arming.ARMED, _ARM),
    (Arming.DISARMED, OutputEvent.STOP): (Arming.DISARMED, _DROP),
    (Arming.DISARMED, OutputEvent.NOT_RESPONDING): (Arming.UNREACHABLE, _UNREACHABLE),
    (Arming.UNREACHABLE, OutputEvent.STOP): (Arming.UNREACHABLE, _DROP),
    (Arming.UNREACHABLE, OutputEvent.NOT_RESPONDING): (Arming.UNREACHABLE, _UNREACHABLE),
    (Arming.UNREACHABLE, OutputEvent.BOARD_READ): (Arming.DISARMED, ()),
}
"""Next state and actions for each state and event. Other events have no effect."""

_MOTION: Mapping[tuple[Motion, OutputEvent], tuple[Motion, tuple[Action, ...]]] = {
    (Motion.STOPPED, OutputEvent.SETPOINT_SENT): (Motion.DRIVEN, ()),
    (Motion.STOPPED, OutputEvent.DIRECT_COMMAND_SENT): (Motion.DRIVEN, ()),
    # On a noisy line, a packet may have reached the board as another command.
    (Motion.STOPPED, OutputEvent.STOP_CLEAN_BUT_NOISY): (Motion.STOP_UNCONFIRMED, ()),
    (Motion.DRIVEN, OutputEvent.STOP_CONFIRMED): (Motion.STOPPED, _CONFIRM),
    (Motion.DRIVEN, OutputEvent.STOP_CLEAN_BUT_NOISY): (Motion.STOP_UNCONFIRMED, ()),
    (Motion.DRIVEN, OutputEvent.STOP_NOT_ANSWERED): (Motion.STOP_UNCONFIRMED, ()),
    (Motion.STOP_UNCONFIRMED, OutputEvent.STOP_CONFIRMED): (Motion.STOPPED, _CONFIRM),
    (Motion.STOP_UNCONFIRMED, OutputEvent.SETPOINT_SENT): (Motion.DRIVEN, _FAIL),
}
"""Transitions of `Motion`. A direct command does not end the retries of a stop."""


class MotorOutput:
    """Arming, motion and queued commands of one board's motors."""

    def __init__(
        self,
        report: Callable[[Outcome | MotorReport], None],
        timeouts: Timeouts | None = None,
        *,
        may_move: bool = False,
    ) -> None:
        self.arming = Arming.INITIAL
        self.motion = Motion.DRIVEN if may_move else Motion.STOPPED
        self.stops: list[Stop] = []  # requested stops that have not been sent yet
        self.setpoints = SetpointSlots()
        self._popped: list[Setpoint] = []  # last popped setpoints, unless dropped since
        self.quality = LineQuality()
        self.restart = RestartWatch(self.quality)
        self.refresh = SetpointRefresh(self.quality, lambda: self.restart.is_checking)
        self.report = report
        self._timeouts = timeouts or Timeouts()
        self.retry = SetpointRetry()
        self._sent_at = 0.0
        self._heartbeat_at = -math.inf
        self._stopped_at = -math.inf
        self._noisy_stops: list[Stop] = []
        self._noisy_until = -math.inf
        self.is_repeating = False  # True from a `CommandsRepeated` report until the line is quiet

    @property
    def is_armed(self) -> bool:
        return self.arming is Arming.ARMED

    @property
    def may_move(self) -> bool:
        """True if a motor was driven and no stop has been confirmed since."""
        return self.motion is not Motion.STOPPED

    def handle(self, event: OutputEvent, now: float) -> None:
        self.arming, actions = _ARMING.get((self.arming, event), (self.arming, ()))
        self.motion, more = _MOTION.get((self.motion, event), (self.motion, ()))
        for action in (*actions, *more):
            match action:
                case Action.START_WATCHDOG:
                    self._heartbeat_at = now
                    self.refresh.on_armed()
                case Action.DROP_SETPOINTS:
                    self.setpoints.clear()
                    self._popped = []
                    self.retry.clear()
                    self.refresh.clear()
                    self.restart.clear()
                case Action.FAIL_NOISY_STOPS:
                    self._end_noisy_stops(TrexNoReplyError(ErrorCode.STOP_ON_NOISY_LINE))
                case Action.CONFIRM_NOISY_STOPS:
                    self._end_noisy_stops(None)

    # --- Requests -----------------------------------------------------------------------

    def handle_request(self, request: MotorRequest, now: float) -> None:
        """Handle a request. Drop invalid setpoints, and setpoints that `arming` forbids."""
        match request:
            case Stop():
                self.stops.append(request)
                self.handle(OutputEvent.STOP, now)
            case Arm():
                self.handle(OutputEvent.ARM, now)
            case Heartbeat(sent=sent):
                self._record_heartbeat(now if sent is None else sent)
            case _ if not is_valid(request):
                log.warning("an invalid setpoint was dropped: %s", request)
            case _:
                self._record_heartbeat(now)
                if self.arming in {Arming.INITIAL, Arming.ARMED}:
                    self.setpoints.put(request)

    def _record_heartbeat(self, time: float) -> None:
        # After the computer was suspended, a late heartbeat must not hide the timeout.
        if time - self._heartbeat_at <= self._timeouts.heartbeat:
            self._heartbeat_at = max(self._heartbeat_at, time)

    # --- Next actions -------------------------------------------------------------------

    # Each `seconds_to_…` method counts from `now` and returns infinity if nothing is due.
    # `interval` is the minimum time in seconds between motor packets.

    def seconds_to_heartbeat_timeout(self, now: float) -> float:
        return self._heartbeat_at + self._timeouts.heartbeat - now if self.is_armed else math.inf

    def seconds_to_stop_retry(self, now: float) -> float:
        if self.motion is not Motion.STOP_UNCONFIRMED or self.arming is Arming.UNREACHABLE:
            return math.inf
        return self._stopped_at + STOP_RETRY_INTERVAL - now

    def seconds_to_drive(self, now: float, interval: float) -> float:
        due = min(
            self._sent_at if self.setpoints else math.inf,
            self.retry.due,
            self.refresh_due(interval),
        )
        return max(due, self._sent_at + interval) - now

    def refresh_due(self, interval: float) -> float:
        due = math.inf
        if self.arming is not Arming.UNREACHABLE:
            due = self.refresh.due(interval)
        self.is_repeating = self.is_repeating and due < math.inf
        return due

    def record_refresh(self) -> None:
        """Report `CommandsRepeated`, but only once until the line is quiet."""
        if not self.is_repeating:
            self.is_repeating = True
            self.report(CommandsRepeated())

    def has_due_setpoints(self, now: float) -> bool:
        return bool(self.setpoints) or self.retry.due <= now

    def pop_setpoints(self, now: float) -> list[Setpoint]:
        """Return queued setpoints, or else due retries, and record them as sent."""
        self._sent_at = now
        if setpoints := self.setpoints.pop():
            self.retry.start(setpoints, now)
        elif self.retry.due <= now:
            setpoints = self.retry.pop_due(now)
        if setpoints:
            self.handle(OutputEvent.SETPOINT_SENT, now)
            self.refresh.record_setpoints(setpoints, now)
            self.restart.record_setpoints(setpoints, now)
        self._popped = setpoints
        return setpoints

    def put_back_setpoints(self) -> None:
        """Queue the popped setpoints again, unless a stop has dropped them since."""
        self.setpoints.put_back(self._popped)

    def record_status(self, latched: LatchedStatus, *, stops_on_error: bool) -> None:
        self.quality.record_status(latched)
        self.refresh.record_status(latched, stops_on_error=stops_on_error)
        self.restart.record_status(latched, stops_on_error=stops_on_error)
        self.retry.record_status(latched, stops_on_error=stops_on_error)

    # --- Stops and their outcomes -------------------------------------------------------

    def pop_stops(self) -> list[Stop]:
        stops = self._noisy_stops + self.stops
        self._noisy_stops, self.stops = [], []
        return stops

    def put_back(self, stops: Sequence[Stop]) -> None:
        self.stops[:0] = stops

    def record_stop(
        self, now: float, statuses: Sequence[LatchedStatus], *, confirmed: bool, final: bool
    ) -> None:
        """Record the result of a stop. All setpoints are idle after a stop.

        `confirmed`: True if enough clean statuses followed. `final`: True if the stop does not
        wait for a quiet line.
        """
        self._sent_at = self._stopped_at = now
        was_driven = self.may_move
        for latched in statuses:
            self.quality.record_status(latched)
        if not confirmed:
            self.handle(OutputEvent.STOP_NOT_ANSWERED, now)
        elif final or self.quality.is_quiet:
            self.handle(OutputEvent.STOP_CONFIRMED, now)
        else:
            self.handle(OutputEvent.STOP_CLEAN_BUT_NOISY, now)
        self.refresh.record_stop(now, was_driven=was_driven or self.may_move)

    def end_stops(self, stops: Sequence[Stop], now: float, *, answered: bool) -> None:
        """Report the outcome of stops that were sent.

        On a line that damages bytes, the stop is retried until the line is quiet, or until
        `Timeouts.stop_confirmation` expires. Stops of an unreachable board end at once.
        """
        if not answered:
            self.report_stops(stops, TrexNoReplyError(ErrorCode.STOP_UNCONFIRMED))
        elif not self.may_move:
            self.report_stops(stops, None)
        elif self.arming is Arming.UNREACHABLE:
            self.report_stops(stops, TrexNoReplyError(ErrorCode.STOP_ON_NOISY_LINE))
        else:
            self._noisy_stops = list(stops)
            self._noisy_until = now + self._timeouts.stop_confirmation

    def end_stop_retry(self) -> None:
        if not self.may_move:
            self.report(MotorsStopped(None, confirmed=True))
        elif self._stopped_at >= self._noisy_until:
            self._end_noisy_stops(TrexNoReplyError(ErrorCode.STOP_ON_NOISY_LINE))

    def report_stops(self, stops: Sequence[Stop], error: StudioError | None) -> None:
        for stop in stops:
            self.report(Outcome(stop.id, error=error))

    def _end_noisy_stops(self, error: StudioError | None) -> None:
        stops, self._noisy_stops = self._noisy_stops, []
        self.report_stops(stops, error)
