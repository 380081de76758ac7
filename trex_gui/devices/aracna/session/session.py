"""Session loop on a line to the robot: requests in, reports out.

The loop uses neither threads nor Qt. Without a request it sends only `.q`, because a TReX may be on
the port, and any other line may harm a TReX at some settings. (At 38400 baud with odd parity, a
TReX reads `.q` as E1, the start of a motor command, and a newline that is sent separately as data.
So `.q` and two newlines become E1 0A 0A, which drives motor 1.) The robot has no stop command.
After a `Halt`, the loop merely sends no more commands.
"""

from collections.abc import Callable

from trex_gui.core.errors import BadRequest, NoReply, StudioError
from trex_gui.core.session import SHORTEST_WAIT, Close, Closed, Closing, Inbox, run_until_closed
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol import commands
from trex_gui.devices.aracna.protocol.replies import UNREADABLE, Led, Positions, Speeds, Version
from trex_gui.devices.aracna.session.client import (
    LINE,
    Answered,
    AracnaClient,
    CommandEvent,
    ReplyLost,
    SentCommand,
    Voided,
)
from trex_gui.devices.aracna.session.errors import (
    ABORT_TOLERANCE,
    ErrorCode,
    RobotBusyError,
    RobotError,
    RobotInternalError,
    RobotNoReplyError,
    diagnose,
    missed_goals,
    rejected_speeds,
)
from trex_gui.devices.aracna.session.job_queue import Job, JobQueue
from trex_gui.devices.aracna.session.liveness import QUERY_INTERVAL, LivenessMonitor, QueryReason
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Ending,
    EndPlay,
    Halt,
    LineStats,
    Move,
    Moved,
    Moving,
    NotResponding,
    Play,
    Progress,
    Report,
    Request,
    Restarted,
    SetLed,
    SetLimits,
    SetSpeeds,
    SetTimeScale,
    SpeedsHeld,
    Stuck,
)
from trex_gui.devices.aracna.session.player import SequencePlayer
from trex_gui.devices.aracna.session.servo_estimates import (
    SPEED_VALIDITY,
    SPEED_VALIDITY_BEFORE_MOVE,
    ServoEstimates,
    move_timeout,
)

STATS_INTERVAL = 1.0  # seconds between reports of the line's statistics
_READ_TIMEOUT = 0.02  # seconds
_IDLE = 0.05  # maximum wait in seconds for requests, between checks for `.h`


class AracnaSession:
    def __init__(
        self,
        settings: PortSettings,
        inbox: Inbox[Request],
        report: Callable[[Report], None],
        open_transport: Callable[[PortSettings], Transport],
    ) -> None:
        self._settings = settings.at(LINE)
        self._inbox = inbox
        self._report = report
        self._open_transport = open_transport
        self._servos = ServoEstimates()
        self._jobs = JobQueue(report)
        self._player = SequencePlayer(report, self._servos)
        self._is_stuck = False  # True while a late reply to a motion is awaited
        self._reported_stats = LineStats()
        self._is_open = False

    def run(self) -> None:
        """Serve the line until it is lost or `Close` arrives, then report `Closed`.

        Never raises. Closes the port, and reports an outcome for every request.
        """
        error = run_until_closed(
            self._open, self._step, lambda detail: RobotInternalError(ErrorCode.INTERNAL, detail)
        )
        if self._is_open:
            self._client.transport.close()
        reason = error or RobotError(ErrorCode.CLOSED)
        while (request := self._inbox.get(0.0)) is not None:
            self._jobs.reject(request, reason)
        if self._is_open:
            self._drop(self._now(), Ending.LOST, reason)
        self._report(Closed(error))

    def _open(self) -> None:
        self._client = AracnaClient(self._open_transport(self._settings), self._settings)
        self._next_stats = self._now()
        self._liveness = LivenessMonitor(self._now())
        self._is_open = True

    def _now(self) -> float:
        return self._client.transport.clock()

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        if self._client.pending is not None:
            self._handle_requests(0.0)
            self._handle(self._client.listen(_READ_TIMEOUT))
        else:
            self._handle_requests(max(SHORTEST_WAIT, min(self._seconds_to_wait(), _IDLE)))
            self._handle(self._client.listen())
            if self._client.pending is None:
                self._send_next()
        stats, now = self._client.stats, self._now()
        if now >= self._next_stats and stats.finished != self._reported_stats.finished:
            self._reported_stats, self._next_stats = stats, now + STATS_INTERVAL
            self._report(stats)

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
            self._set_not_responding(RobotNoReplyError(ErrorCode.TIMEOUT))
        elif liveness.reason is not None:
            if query_due:
                self._client.query(QUERY_INTERVAL)
        elif self._jobs.has_queued:  # requested before the sequence started
            self._jobs.send_next(self._send)
        elif self._player.seconds_to_next(now) <= 0:
            self._play(now)
        elif query_due:
            self._client.query()

    # --- Requests -----------------------------------------------------------------------

    def _handle_requests(self, seconds: float) -> None:
        request = self._inbox.get(seconds)
        while request is not None:
            if isinstance(request, Close):
                raise Closing
            try:
                self._handle_request(request)
            except (BadRequest, NoReply) as error:
                self._jobs.reject(request, error)
            request = self._inbox.get(0.0)

    def _handle_request(self, request: Request) -> None:
        match request:
            case Halt():
                self._drop(self._now(), Ending.HALTED, RobotError(ErrorCode.HALTED))
            case SetLimits(limits=limits):
                self._servos.limits = limits
            case EndPlay():
                self._player.end()
            case SetTimeScale(time_scale=scale):
                self._player.set_time_scale(scale)
            case Play():
                self._check_ready()
                self._player.start(request, self._now())
            case Move() | SetSpeeds() | SetLed():
                self._check_ready()
                self._jobs.add(request)

    def _check_ready(self) -> None:
        if not self._liveness.is_responding:
            raise RobotNoReplyError(ErrorCode.NOT_READY)
        if self._player.is_playing:
            raise RobotBusyError(ErrorCode.PLAYING)
        if self._is_stuck:
            raise RobotNoReplyError(ErrorCode.STUCK)

    def _drop(self, now: float, ending: Ending, reason: StudioError) -> None:
        """Drop queued requests and stop playing. After a halt, the command in flight continues."""
        is_halt = ending is Ending.HALTED
        if not is_halt:
            self._jobs.finish(error=reason)
        self._player.stop(now, ending, None if is_halt else reason)
        self._jobs.drop(reason)

    # --- Sending ------------------------------------------------------------------------

    def _send(self, job: Job) -> bool:
        """Send a job. Return True if only the speeds of a motion were sent.

        Raises BadRequest for invalid values or a wrong number of values.
        """
        match job:
            case Move(goals=goals, speeds=speeds, dragged=dragged):
                validity = SPEED_VALIDITY if dragged else SPEED_VALIDITY_BEFORE_MOVE
                self._servos.expire_speeds(self._now(), validity)
                if speeds is not None and speeds != self._servos.speeds:
                    # Raises BadRequest before the speeds are sent.
                    commands.positions(self._servos.clamp(goals), self._client.motors)
                    self._client.set_speeds(speeds)
                    return True
                self._move(goals)
            case SetSpeeds(speeds=speeds):
                self._client.set_speeds(speeds)
            case SetLed(on=on):
                self._client.set_led(on=on)
        return False

    def _move(self, goals: tuple[int, ...]) -> None:
        goals = self._servos.clamp(goals)
        fits = len(goals) == self._client.motors
        expected = self._servos.seconds_to(goals) if fits else 0.0
        self._client.move(goals, move_timeout(expected))
        starts = self._servos.present
        self._servos.clear_positions()
        self._report(Moving(self._now(), goals, starts, expected))

    def _play(self, now: float) -> None:
        self._servos.expire_speeds(now)
        if (speeds := self._player.next_speeds(now)) is not None:
            self._client.set_speeds(speeds)
        elif (goals := self._player.next_goals()) is not None:
            self._move(goals)

    # --- Replies ------------------------------------------------------------------------

    def _handle(self, events: list[CommandEvent]) -> None:
        for event in events:
            match event:
                case Answered(time=time):
                    self._liveness.on_reply(time)
                    self._on_answered(event)
                case Progress(time=time):
                    self._liveness.on_reply(time)
                    self._report(event)
                case Stuck():
                    self._on_stuck(event)
                case ReplyLost():
                    self._on_reply_lost(event)
                case Voided(command=command, time=time):
                    self._on_restart(command, time)

    def _on_answered(self, answer: Answered) -> None:
        command, now = answer.command, answer.time
        self._is_stuck = False
        match answer.reply:
            case Version():
                self._on_version(answer.reply, now)
            case Speeds(values=held):
                self._servos.on_speeds(held, now)
                self._report(speeds := SpeedsHeld(now, command.values, held))
                self._on_speeds(speeds)
            case Positions(values=present):
                self._servos.on_positions(command.values, present, now)
                self._report(moved := Moved(now, command.values, present, now - command.sent))
                self._player.on_arrival()
                errors = missed_goals(command.values, present, ABORT_TOLERANCE).values()
                if missed := tuple(e for e in errors if e.code is ErrorCode.GOAL_MISSED):
                    error = RobotNoReplyError(ErrorCode.GOALS_MISSED, missed)
                    self._player.stop(now, Ending.MISSED, error)
                self._jobs.finish(moved)
            case Led(on=on):
                self._jobs.finish(on)

    def _on_speeds(self, speeds: SpeedsHeld) -> None:
        error = rejected_speeds(speeds.requested, speeds.held)
        if self._jobs.is_setting_speeds:
            if error is None:
                self._jobs.on_speeds_set()
            else:
                self._jobs.finish(error=error)
        elif not self._jobs.finish(speeds) and error is not None:
            self._player.stop(speeds.time, Ending.SPEEDS, error)

    def _on_version(self, reply: Version, now: float) -> None:
        motors = reply.motor_count
        was_responding = self._liveness.is_responding
        self._liveness.on_version(now)
        if motors != self._client.motors:
            self._client.motors = motors
            self._servos.reset(motors)
            if was_responding:  # queued requests are for another robot
                self._drop(now, Ending.LOST, RobotNoReplyError(ErrorCode.OTHER_ROBOT))
                was_responding = False
        if not was_responding:
            self._report(Connected(reply.version, motors))

    def _on_stuck(self, stuck: Stuck) -> None:
        """Drop queued requests, which must not start when a servo recovers."""
        self._is_stuck = True
        self._servos.clear_speeds()  # a servo without power loses its speed
        self._report(stuck)
        error = RobotNoReplyError(ErrorCode.TIMEOUT)
        if stuck.motor is not None:
            error = RobotNoReplyError(ErrorCode.MOTOR_STUCK, stuck.motor)
        self._player.stop(stuck.time, Ending.STUCK, error)
        self._jobs.drop(RobotNoReplyError(ErrorCode.STUCK))

    def _on_reply_lost(self, loss: ReplyLost) -> None:
        if loss.command.letter == "q":
            self._liveness.on_query_timeout(loss.time)
            self._liveness.on_missing_reply(loss.time)
            if self._liveness.timed_out(loss.time):
                self._set_not_responding(loss.error)
            return
        if loss.command.letter == "c":
            self._is_stuck = False
            goals = loss.command.values
            unknown = (UNREADABLE,) * len(goals)
            self._report(Moved(loss.time, goals, unknown, loss.time - loss.command.sent))
        if loss.command.letter in {"c", "v"}:
            self._servos.clear_speeds()
        error: StudioError = loss.error
        if self._jobs.is_setting_speeds:
            error = RobotNoReplyError(ErrorCode.SPEEDS_UNCONFIRMED, loss.error)
        self._jobs.finish(error=error)
        self._player.stop(loss.time, Ending.LOST, loss.error)
        if not loss.robot_free:
            self._liveness.on_missing_reply(loss.time)

    def _on_restart(self, command: SentCommand | None, now: float) -> None:
        was_connecting = self._liveness.reason is QueryReason.CONNECTING
        self._is_stuck = False
        self._liveness.on_restart(now)
        if was_connecting:
            return
        voided = self._player.is_playing or bool(self._jobs)
        voided |= command is not None and command.letter != "q"
        # A reset and a power cut both cause `.h`. Only after a reset do servos retain position
        # and speed.
        self._servos.clear()
        self._report(Restarted(now, voided))
        self._drop(now, Ending.RESTARTED, RobotError(ErrorCode.RESTARTED))

    def _set_not_responding(self, error: StudioError) -> None:
        """Report a robot that does not respond. While connecting, raise the diagnosis."""
        if self._liveness.reason is QueryReason.CONNECTING:
            raise diagnose(self._settings, self._client.received)
        now = self._now()
        self._liveness.set_not_responding(now)
        self._servos.clear()
        self._report(NotResponding(now, error))
        self._drop(now, Ending.LOST, RobotNoReplyError(ErrorCode.NOT_RESPONDING))
