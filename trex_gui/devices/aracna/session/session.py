"""The loop that owns a line to the robot: requests in, reports out, one command in flight.

It uses neither threads nor Qt. Unprompted it sends only `.q`, the one line that is also harmless to
a TReX at any settings, which may be on the port. (With a newline before it, a TReX at 38400 baud
with odd parity may take both for a command.) This link has no stop: `Halt` can only send nothing
more.
"""

from collections.abc import Callable

from trex_gui.core.errors import BadRequest, NoReply
from trex_gui.core.session import SHORTEST_WAIT, Close, Closed, Closing, Inbox, run_until_closed
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol import commands
from trex_gui.devices.aracna.session.client import LINE, AracnaClient
from trex_gui.devices.aracna.session.errors import (
    ErrorCode,
    RobotBusyError,
    RobotError,
    RobotNoReplyError,
)
from trex_gui.devices.aracna.session.job_queue import Job, JobQueue
from trex_gui.devices.aracna.session.liveness import QUERY_INTERVAL, LivenessMonitor
from trex_gui.devices.aracna.session.messages import (
    Drag,
    Ending,
    EndPlay,
    Halt,
    LineStats,
    LineStatsChanged,
    Move,
    Moving,
    Play,
    Report,
    Request,
    SetLed,
    SetLimits,
    SetSpeeds,
    SetTimeScale,
)
from trex_gui.devices.aracna.session.player import SequencePlayer
from trex_gui.devices.aracna.session.reply_handler import ReplyHandler
from trex_gui.devices.aracna.session.servo_estimates import (
    TRUST,
    TRUST_BEFORE_MOVE,
    ServoEstimates,
    move_timeout,
)

STATS_INTERVAL = 1.0
"""Seconds between two reports of the line's statistics."""

_SLICE = 0.02
"""Seconds to wait for reply bytes before checking for requests."""

_IDLE = 0.05
"""Seconds to wait for requests before checking the line: a `.h` may arrive."""


class AracnaSession:
    """Serves one line from opening to closing it."""

    def __init__(
        self,
        settings: PortSettings,
        inbox: Inbox[Request],
        report: Callable[[Report], None],
        open_transport: Callable[[PortSettings], Transport] = SerialTransport,
    ) -> None:
        self._settings = settings.at(LINE)
        self._inbox = inbox
        self._report = report
        self._open_transport = open_transport
        self._servos = ServoEstimates()
        self._jobs = JobQueue(report, self._now)
        self._player = SequencePlayer(report, self._servos)
        self._reported_stats = LineStats()
        self._is_open = False

    def run(self) -> None:
        """Serve the line until it is lost or `Close` arrives, then report `Closed`.

        Never raises. The port is always closed, and every request gets its outcome.
        """
        error = run_until_closed(
            self._open, self._step, lambda detail: RobotError(ErrorCode.INTERNAL, detail)
        )
        if self._is_open:
            self._client.transport.close()
        reason = error or RobotError(ErrorCode.CLOSED)
        while (request := self._inbox.get(0.0)) is not None:
            self._jobs.reject(request, reason)
        if self._is_open:
            self._handler.drop(self._now(), Ending.LOST, reason)
        self._report(Closed(error))

    def _open(self) -> None:
        transport = self._open_transport(self._settings)
        client = self._client = AracnaClient(transport, self._settings)
        self._next_stats = self._now()
        self._liveness = LivenessMonitor(self._now())
        self._handler = ReplyHandler(client, self._liveness, self._jobs, self._player, self._report)
        self._is_open = True

    def _now(self) -> float:
        return self._client.transport.clock()

    def _report_stats(self) -> None:
        stats, now = self._client.stats, self._now()
        if now >= self._next_stats and stats.finished != self._reported_stats.finished:
            self._reported_stats, self._next_stats = stats, now + STATS_INTERVAL
            self._report(LineStatsChanged(stats))

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        self._use_line()
        self._report_stats()

    def _use_line(self) -> None:
        if self._client.pending is not None:
            self._take_requests(0.0)
            self._handler.handle(self._client.listen(_SLICE))
            return
        self._take_requests(max(SHORTEST_WAIT, min(self._seconds_to_wait(), _IDLE)))
        self._handler.handle(self._client.listen())
        if self._client.pending is None:
            self._send_next()

    def _seconds_to_wait(self) -> float:
        now = self._now()
        seconds = self._liveness.seconds_to_query(now)
        if self._liveness.reason is not None:
            return seconds
        return 0.0 if self._jobs.has_queued else min(seconds, self._player.seconds_to_next(now))

    def _send_next(self) -> None:
        now, liveness = self._now(), self._liveness
        query_due = liveness.seconds_to_query(now) <= 0
        if liveness.timed_out(now):
            self._handler.set_not_responding(RobotNoReplyError(ErrorCode.TIMEOUT))
        elif liveness.reason is not None:
            if query_due:
                self._client.query(QUERY_INTERVAL)
        elif self._jobs.has_jobs:  # queued before the sequence, so sent before it
            self._jobs.send_next(self._send)
        elif self._player.seconds_to_next(now) <= 0:
            self._play(now)
        elif self._jobs.drag is not None:
            self._jobs.send_next(self._send)
        elif query_due:
            self._client.query()

    # --- Requests -----------------------------------------------------------------------

    def _take_requests(self, seconds: float) -> None:
        request = self._inbox.get(seconds)
        while request is not None:
            if isinstance(request, Close):
                raise Closing
            try:
                self._take(request)
            except (BadRequest, NoReply) as error:
                self._jobs.reject(request, error)
            request = self._inbox.get(0.0)

    def _take(self, request: Request) -> None:
        match request:
            case Halt():
                self._handler.drop(self._now(), Ending.HALTED, RobotError(ErrorCode.HALTED))
            case Drag():
                self._take_drag(request)
            case SetLimits(limits=limits):
                self._servos.set_limits(limits)
            case EndPlay():
                self._player.end()
            case SetTimeScale(time_scale=scale):
                self._player.set_time_scale(scale)
            case Play():
                self._check_ready()
                self._jobs.drop_drag()
                self._player.start(request, self._now())
            case Move() | SetSpeeds():
                self._check_ready()
                self._jobs.add(request)
            case SetLed():
                self._check_responding()
                self._jobs.add(request)
            case _:
                pass

    def _take_drag(self, drag: Drag) -> None:
        if not self._liveness.is_responding or self._player.is_playing:
            return
        if self._handler.is_stuck:
            self._jobs.reject_drag(drag, RobotNoReplyError(ErrorCode.STUCK))
        else:
            self._jobs.drag = drag

    def _check_responding(self) -> None:
        if not self._liveness.is_responding:
            raise RobotNoReplyError(ErrorCode.NOT_READY)

    def _check_ready(self) -> None:
        self._check_responding()
        if self._player.is_playing:
            raise RobotBusyError(ErrorCode.PLAYING)
        if self._handler.is_stuck:
            raise RobotNoReplyError(ErrorCode.STUCK)

    # --- Sending ------------------------------------------------------------------------

    def _send(self, job: Job | Drag) -> bool:
        """Send a job, or first the speeds of a motion; return whether it was only those.

        Raises:
            BadRequest: not one value of 0-1023 for each motor.
            PortUnavailable: the line is gone.
        """
        match job:
            case Move(goals=goals, speeds=speeds) | Drag(goals=goals, speeds=speeds):
                trust = TRUST_BEFORE_MOVE if isinstance(job, Move) else TRUST
                self._servos.expire_speeds(self._now(), trust)
                if speeds is not None and speeds != self._servos.speeds:
                    commands.positions(self._servos.crop(goals), self._client.motors)  # checks them
                    self._client.set_speeds(speeds)
                    return True
                self._move(goals)
            case SetSpeeds(speeds=speeds):
                self._client.set_speeds(speeds)
            case SetLed(on=on):
                self._client.set_led(on=on)
        return False

    def _move(self, goals: tuple[int, ...]) -> None:
        goals = self._servos.crop(goals)
        fits = len(goals) == self._client.motors
        expected = self._servos.seconds_to(goals) if fits else 0.0
        self._client.move(goals, move_timeout(expected))
        starts = self._servos.present
        self._servos.forget_positions()
        self._report(Moving(self._now(), goals, starts, expected))

    def _play(self, now: float) -> None:
        self._servos.expire_speeds(now)
        if (speeds := self._player.next_speeds(now)) is not None:
            self._client.set_speeds(speeds)
        elif (goals := self._player.next_goals()) is not None:
            self._move(goals)
