"""What command events mean for queued requests, the playing sequence and the servo estimates."""

from collections.abc import Callable

from trex_gui.core.errors import StudioError
from trex_gui.devices.aracna.protocol.replies import UNREADABLE, Led, Positions, Speeds, Version
from trex_gui.devices.aracna.session.client import (
    Answered,
    AracnaClient,
    CommandEvent,
    LateReply,
    PartialReply,
    ReplyLost,
    SentCommand,
    Voided,
)
from trex_gui.devices.aracna.session.errors import (
    ErrorCode,
    RobotError,
    RobotNoReplyError,
    diagnose,
    rejected_speeds,
)
from trex_gui.devices.aracna.session.job_queue import JobQueue
from trex_gui.devices.aracna.session.liveness import LivenessMonitor, QueryReason
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Ending,
    Moved,
    NotResponding,
    Passed,
    Report,
    Restarted,
    SpeedsHeld,
    Stuck,
)
from trex_gui.devices.aracna.session.player import SequencePlayer
from trex_gui.devices.aracna.session.servo_estimates import missed


class ReplyHandler:
    """Handles and reports the events of a session's commands.

    Attributes:
        is_stuck: whether a late reply to a motion is still awaited.
    """

    def __init__(
        self,
        client: AracnaClient,
        liveness: LivenessMonitor,
        jobs: JobQueue,
        player: SequencePlayer,
        report: Callable[[Report], None],
    ) -> None:
        self.is_stuck = False
        self._client = client
        self._liveness = liveness
        self._servos = player.servos
        self._jobs = jobs
        self._player = player
        self._report = report

    def drop(self, now: float, why: Ending, reason: StudioError) -> None:
        """Drop all queued requests; after a halt the one in flight continues."""
        is_halt = why is Ending.HALTED
        if not is_halt:
            self._jobs.finish(error=reason)
        self._player.stop(now, why, None if is_halt else reason)
        self._jobs.drop(reason)

    def handle(self, events: list[CommandEvent]) -> None:
        for event in events:
            match event:
                case Answered(time=time):
                    self._liveness.on_reply(time)
                    self._on_answered(event)
                case PartialReply(present=present, time=time):
                    self._liveness.on_reply(time)
                    self._report(Passed(time, present))
                case LateReply(motor=motor, time=time):
                    self._on_late_reply(motor, time)
                case ReplyLost():
                    self._on_reply_lost(event)
                case Voided(command=command, time=time):
                    self._on_restart(command, time)

    def _on_late_reply(self, motor: int | None, now: float) -> None:
        """Drop what is queued: it must not start when a servo recovers, perhaps in an hour."""
        self.is_stuck = True
        self._servos.forget_speeds()  # a servo without power loses its speed
        self._report(Stuck(now, motor))
        code, fields = (
            (ErrorCode.TIMEOUT, ()) if motor is None else (ErrorCode.MOTOR_STUCK, (motor,))
        )
        self._player.stop(now, Ending.STUCK, RobotNoReplyError(code, *fields))
        self._jobs.drop(RobotNoReplyError(ErrorCode.STUCK))

    def _on_answered(self, answer: Answered) -> None:
        command, now = answer.command, answer.time
        self.is_stuck = False
        match answer.reply:
            case Version():
                self._on_version(answer.reply, now)
            case Speeds(values=held):
                self._servos.on_speeds(held, now)
                speeds = SpeedsHeld(now, command.values, held)
                self._report(speeds)
                self._on_speeds(speeds)
            case Positions(values=present):
                self._servos.on_positions(command.values, present, now)
                moved = Moved(now, command.values, present, now - command.sent)
                self._report(moved)
                self._player.on_arrival()
                if off := tuple(missed(command.values, present).items()):
                    self._player.stop(
                        now, Ending.MISSED, RobotNoReplyError(ErrorCode.GOALS_MISSED, off)
                    )
                self._jobs.finish(moved)
            case Led(on=on):
                self._jobs.finish(on)

    def _on_speeds(self, speeds: SpeedsHeld) -> None:
        """Start a motion only if every servo has taken its speed."""
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
        was_restarted, was_responding = self._liveness.was_restarted, self._liveness.is_responding
        reason = self._liveness.on_version(now)
        if motors != self._client.motors:
            self._client.motors = motors
            self._servos.reset(motors)
            if was_responding:  # queued requests were meant for another robot
                self.drop(now, Ending.LOST, RobotNoReplyError(ErrorCode.OTHER_ROBOT))
                reason, was_responding = QueryReason.NOT_RESPONDING, False
        if not was_responding:
            restarted = was_restarted and reason is not QueryReason.CONNECTING
            self._report(Connected(reply.version, motors, self._client.settings, restarted))

    def _on_reply_lost(self, loss: ReplyLost) -> None:
        if loss.command.letter == "q":
            self._liveness.on_query_timeout(loss.time)
            self._liveness.on_missing_reply(loss.time)
            if self._liveness.timed_out(loss.time):
                self.set_not_responding(loss.error)
            return
        if loss.command.letter == "c":
            self.is_stuck = False
            goals = loss.command.values
            unknown = (UNREADABLE,) * len(goals)
            self._report(Moved(loss.time, goals, unknown, loss.time - loss.command.sent))
        if loss.command.letter in {"c", "v"}:
            self._servos.forget_speeds()
        error: StudioError = loss.error
        if self._jobs.is_setting_speeds:
            error = RobotNoReplyError(ErrorCode.SPEEDS_UNCONFIRMED, loss.error)
        self._jobs.finish(error=error)
        self._player.stop(loss.time, Ending.LOST, loss.error)
        if not loss.robot_free:
            self._liveness.on_missing_reply(loss.time)

    def _on_restart(self, command: SentCommand | None, now: float) -> None:
        was_connecting = self._liveness.reason is QueryReason.CONNECTING
        self.is_stuck = False
        self._liveness.on_restart(now)
        if was_connecting:
            return
        voided = self._player.is_playing or bool(self._jobs)
        voided |= command is not None and command.letter != "q"
        # Servos keep position and speed over a reset but not over a power cut; `.h` reports both.
        self._servos.forget()
        self._report(Restarted(now, voided))
        self.drop(now, Ending.RESTARTED, RobotError(ErrorCode.RESTARTED))

    def set_not_responding(self, error: StudioError) -> None:
        """Report that the robot does not respond.

        Raises:
            NoReply, BadReply: no robot has ever answered; says what to check.
        """
        if self._liveness.reason is QueryReason.CONNECTING:
            raise diagnose(self._client.settings, self._client.received)
        now = self._client.transport.clock()
        self._liveness.set_not_responding(now)
        self._servos.forget()
        self._report(NotResponding(error))
        self.drop(now, Ending.LOST, RobotNoReplyError(ErrorCode.NOT_RESPONDING))
