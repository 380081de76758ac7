"""Driver that sends setpoints and stops through a client and confirms the stops.

A stop is the only motor command that is sent without a request. Motor commands have no reply. A
stop is confirmed if several statuses in a row, each after a stop, show no line error.
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.core.session import SHORTEST_WAIT
from trex_gui.devices.trex.client.client import BOARD_DELAY, LONGEST_REPLY, TrexClient
from trex_gui.devices.trex.client.telemetry import LatchedStatus, StatusReader
from trex_gui.devices.trex.driving.motor_output import MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import (
    HEARTBEAT_INTERVAL,
    MotorsStopped,
    Stop,
    StopSent,
    packets,
)
from trex_gui.devices.trex.protocol.commands import STOP
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexNoReplyError
from trex_gui.devices.trex.protocol.flags import Status, UartError

DRIVE_INTERVAL = 0.02  # minimum seconds between motor packets; the board acts every 10 ms

_DRIVE_BYTES = 11  # size of expanded packets with CRC for both motors and the auxiliary motor

# Maximum rounds of a stop, and of its retry
_ATTEMPTS = 20
_RETRY_ATTEMPTS = 4

_CLEAN_ROUNDS = 2
"""Consecutive clean rounds that confirm a stop. In a clean round, a clean status follows a stop.

A board receives nothing while it replies to an earlier query, and latches no error for packets that
it misses entirely. So it can miss one round, but not the round after its reply.
"""

_CAREFUL_ROUNDS = 8
"""Consecutive clean rounds that confirm a stop on a line that damages bytes.

They are required for a stop that cannot wait for a quiet line. Undetected damage may still turn the
last brake of a motor into a speed. For each motor, the probability is 2p/9 * (1 - p)**56 for a
damage probability p per byte, at most 0.15 %. See `QUIET` for a stronger confirmation.
"""

# Limits of the stop before the port is closed. The window waits one second for this stop.
_CLOSING_ATTEMPTS = 6
_CAREFUL_CLOSING_ATTEMPTS = 16  # on a line that damages bytes
_CLOSING_SECONDS = 0.5  # time after which no further round starts


@dataclass(slots=True, eq=False)
class StopRun:
    """Stop of one board, repeated until clean statuses confirm it. See `stop_together`."""

    driver: "MotorDriver"
    attempts: int  # remaining rounds
    rounds: int  # consecutive clean rounds that confirm the stop
    is_final: bool  # True if the stop does not wait for a quiet line
    aborts: Callable[[], bool]  # called after a round that was not clean; True ends the stop
    stops: Sequence[Stop]  # requests that this stop serves; queued again if the line is gone
    end: Callable[[bool], None]  # called at the end, with True if the board confirmed the stop
    clean: int = 0  # consecutive clean rounds
    latched: list[LatchedStatus] = field(default_factory=list)
    was_sent: bool = False
    max_unanswered: int = _ATTEMPTS  # consecutive unanswered rounds that end the stop
    unanswered: list[NoReply] = field(default_factory=list)  # errors of the last unanswered rounds

    @property
    def is_confirmed(self) -> bool:
        return self.clean == self.rounds


@dataclass(slots=True, eq=False)
class MotorDriver:
    """Drives and stops the motors of one board.

    Every method that uses the line raises `PortUnavailable` if the line is gone.
    """

    output: MotorOutput  # state of the motors; receives the requests
    client: TrexClient  # replaced by the owner if the connection settings change
    _status: StatusReader
    # Called with the statuses that were read, since reading a status clears its bits
    _on_statuses: Callable[[Sequence[LatchedStatus]], None] = lambda _: None
    # Returns True while the port is closing, which ends a stop after an unclean round
    _is_closing: Callable[[], bool] = lambda: False

    def _send_stop(self) -> None:
        for command in STOP:
            self.client.send(command)
        self.output.report(StopSent())

    def _stop(
        self,
        attempts: int,
        *,
        is_final: bool = False,
        is_careful: bool = False,
        aborts: Callable[[], bool] | None = None,
        stops: Sequence[Stop] = (),
        end: Callable[[bool], None] = lambda _: None,
    ) -> StopRun:
        self.output.retry.clear()
        self.output.refresh.clear()  # a refresh during a late reply must not drive the motors
        is_careful = is_careful or (is_final and not self._is_quiet())
        rounds = _CAREFUL_ROUNDS if is_careful else _CLEAN_ROUNDS
        return StopRun(self, attempts, rounds, is_final, aborts or self._is_closing, stops, end)

    def send_stop(self, run: StopRun) -> None:
        run.attempts -= 1
        run.was_sent = False
        with suppress(NoReply, BadReply, BadRequest):  # the other boards must still be stopped
            self._send_stop()
            run.was_sent = True

    def check_stop(self, run: StopRun) -> bool:
        """Read the status after a stop. Return True if the stop is over."""
        run.clean += 1
        try:
            if not run.was_sent:
                raise TrexNoReplyError(ErrorCode.STOP_UNCONFIRMED)
            status = self._status.read(self.client.request)
        except NoReply as error:
            run.clean = 0
            run.unanswered.append(error)
        except BadReply:
            run.clean = 0
            run.unanswered.clear()
        else:
            run.unanswered.clear()
            run.latched += [status] if status else []
            run.clean = run.clean if status.is_clean else 0
        is_over = not run.attempts or len(run.unanswered) >= run.max_unanswered
        return run.is_confirmed or is_over or (not run.clean and run.aborts())

    def finish_stop(self, run: StopRun) -> None:
        confirmed = run.is_confirmed
        self._on_statuses(run.latched)
        self._observe_line()
        self.output.record_stop(self._now(), run.latched, confirmed=confirmed, final=run.is_final)
        run.end(confirmed)

    def stop_and_confirm(self, *, careful: bool = False) -> bool:
        """Run a final stop. Return True if the board has confirmed it."""
        run = self.final_stop(careful=careful)
        stop_together([run])
        return run.is_confirmed

    def final_stop(self, *, careful: bool = False) -> StopRun:
        """Return a stop that does not wait for a quiet line.

        `careful`: True if the line is too new to judge its quality.
        """
        return self._stop(_ATTEMPTS, is_final=True, is_careful=careful)

    def takeover_stop(self) -> StopRun:
        """Return the stop for a line that the guardian has used."""
        self._observe_line()
        self.output.quality.is_shared = False
        return self.final_stop()

    def _end_stops(self, stops: Sequence[Stop], *, answered: bool) -> None:
        if not answered and self._is_closing():
            self.output.put_back(stops)  # `closing_stop` serves them
        else:
            self.output.end_stops(stops, self._now(), answered=answered)

    def closing_stop(self) -> StopRun:
        """Return the stop to run before the port is closed. It serves every requested stop."""
        deadline = self._now() + _CLOSING_SECONDS
        attempts = _CLOSING_ATTEMPTS if self._is_quiet() else _CAREFUL_CLOSING_ATTEMPTS
        stops = self.output.pop_stops()

        def report(confirmed: bool) -> None:
            error = None if confirmed else TrexNoReplyError(ErrorCode.STOP_UNCONFIRMED)
            self.output.report_stops(stops, error)

        def is_late() -> bool:
            return self._now() >= deadline

        return self._stop(attempts, is_final=True, aborts=is_late, stops=stops, end=report)

    def stop_early(self) -> None:
        """Send the requested stops on an untested line, and wait for a possible echo.

        The requests remain queued until they are confirmed. If motors may be moving, an earlier
        session may have driven another board, so a stop to all boards follows.
        """
        if not (self.output.may_move or self.output.stops):
            return
        client, settings = self.client, self.client.settings
        self._send_stop()
        others = settings.reserved - set(settings.group)
        if self.output.may_move and settings.device_number is not None and not others:
            client.settings = replace(settings, device_number=None, reserved=frozenset())
            try:
                self._send_stop()
            finally:
                client.settings = settings
        client.drain()
        client.transport.wait(client.transport.latency)

    def stop_without_reply(self) -> None:
        """Stop motors that may be moving. A silent board may still receive."""
        if self.output.may_move:
            self._send_stop()

    def due_stop(self) -> StopRun | None:
        output, now = self.output, self._now()
        if output.stops:
            stops = output.pop_stops()
            return self._stop(
                _ATTEMPTS,
                stops=stops,
                end=lambda answered: self._end_stops(stops, answered=answered),
            )
        if output.seconds_to_heartbeat_timeout(now) <= 0:
            output.handle(OutputEvent.STOP, now)
            return self._stop(_ATTEMPTS, end=self._report_timeout)
        if output.seconds_to_stop_retry(now) <= 0:
            return self._stop(_RETRY_ATTEMPTS, end=lambda _: output.end_stop_retry())
        return None

    def _report_timeout(self, answered: bool) -> None:
        confirmed = answered and not self.output.may_move
        self.output.report(MotorsStopped(ErrorCode.NO_HEARTBEAT, confirmed))

    def serve(self) -> bool:
        """Send due setpoints, retries or refreshes. Return True if anything was due.

        Raises:
            NoReply, BadReply: a setpoint was not sent, or its echo is missing or corrupted. Unless
                a stop was requested meanwhile, the setpoint is queued again.
        """
        if self.seconds_to_drive() > 0:
            return False
        if self.output.has_due_setpoints(self._now()) and self.client.discard_late_reply():
            return True  # a stop that was requested during the wait comes first
        setpoints = self.output.pop_setpoints(self._now())
        if not setpoints:
            self._refresh()
            return True
        try:
            for command in packets(setpoints):
                self.client.request(command)
        except (NoReply, BadReply):
            self.output.put_back_setpoints()
            raise
        return True

    def seconds_to_next(self) -> float:
        now = self._now()
        return min(
            self.output.seconds_to_heartbeat_timeout(now),
            self.output.seconds_to_stop_retry(now),
            self.seconds_to_drive(),
        )

    def seconds_to_drive(self) -> float:
        self._observe_line()
        return self.output.seconds_to_drive(self._now(), self._interval)

    @property
    def _interval(self) -> float:
        # Motor packets may occupy the line at most half of the time.
        return max(DRIVE_INTERVAL, 2 * self.client.settings.line.seconds(_DRIVE_BYTES))

    def avoids_risky_polls(self) -> bool:
        """True if a damaged query could drive a motor."""
        return (self.output.may_move or self.output.is_armed) and not self._is_quiet()

    def _refresh(self, *, is_waiting: bool = False) -> None:
        """Refresh every setpoint.

        `is_waiting`: True while a reply is awaited, so that no status can be read.
        """
        refresh = self.output.refresh
        self.output.record_refresh()
        for command in refresh.idle_commands():
            self.client.send(command)
        refresh.record_sent(self._now())  # the interval starts here, to leave time for polls
        if (refresh.stops_on_error or refresh.holds_speeds) and refresh.running:
            if is_waiting:
                return
            latched = LatchedStatus(self._now(), Status(0), UartError(0), is_whole=False)
            with suppress(NoReply, BadReply):  # polling detects a silent board
                latched = self._status.read(self.client.request)
            self._on_statuses([latched] if latched else [])
            self.output.record_status(latched, stops_on_error=True)
            if not latched.is_whole:
                refresh.record_sent(self._now())  # leave time for polls
                return
        for command in refresh.speeds():
            self.client.send(command)
        refresh.record_sent(self._now())

    def refresh_while_waiting(self, waited: float) -> float:
        """Refresh due setpoints while a reply is late. Return the seconds until the next call."""
        reply = self.client.settings.line.seconds(LONGEST_REPLY) + BOARD_DELAY - waited
        seconds = max(reply, self.output.refresh_due(self._interval) - self._now())
        if self.client.echo:
            return HEARTBEAT_INTERVAL
        if seconds <= 0:
            self._refresh(is_waiting=True)
            seconds = self._interval
        return max(SHORTEST_WAIT, min(seconds, HEARTBEAT_INTERVAL))

    def start_direct(self) -> None:
        """Prepare for a motor command that is not a setpoint."""
        self.output.refresh.on_direct_command()
        self.output.restart.clear()
        self.output.handle(OutputEvent.DIRECT_COMMAND_SENT, self._now())

    def _observe_line(self) -> None:
        self.output.quality.observe(self.client.counters, has_crc=self.client.has_crc)

    def _is_quiet(self) -> bool:
        self._observe_line()
        return self.output.quality.is_quiet

    def _now(self) -> float:
        return self.client.transport.clock()


def stop_together(
    runs: Sequence[StopRun], newly_due: Callable[[], Sequence[StopRun]] = tuple
) -> None:
    """Stop boards on one line. In each round, all stops are sent before a status is read.

    `newly_due` returns the stops of other boards that have become due since its last call.
    """
    unfinished, all_runs = list(runs), list(runs)
    try:
        while unfinished:
            for run in unfinished:
                run.driver.send_stop(run)
            unfinished = [run for run in unfinished if not run.driver.check_stop(run)]
            added = newly_due()
            unfinished += added
            all_runs += added
    except Exception:
        for run in all_runs:
            run.driver.output.put_back(run.stops)
        raise
    for run in all_runs:
        run.driver.finish_stop(run)
