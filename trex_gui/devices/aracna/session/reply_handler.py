"""What the robot's answers mean for what waits, for what is played and for what is known of it."""

from collections.abc import Callable

from trex_gui.core.errors import NoReply, StudioError
from trex_gui.devices.aracna.protocol.replies import Led, Positions, Speeds, Version
from trex_gui.devices.aracna.session.client import AracnaClient
from trex_gui.devices.aracna.session.command_events import (
    Answered,
    LateReply,
    Lost,
    News,
    Passing,
    Sent,
    Voided,
)
from trex_gui.devices.aracna.session.diagnosis import diagnose, why_stuck
from trex_gui.devices.aracna.session.liveness import LivenessMonitor, QueryReason, motors_of
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
from trex_gui.devices.aracna.session.rejections import (
    STUCK,
    why_missed,
    why_not_confirmed,
    why_not_taken,
)
from trex_gui.devices.aracna.session.request_queue import RequestQueue
from trex_gui.devices.aracna.session.servos import Servos, missed

UNREAD = -1
"""Stands for a position that is not known, as in the robot's own answers."""


class ReplyHandler:
    """Hears what comes of what a session has sent, and tells it.

    Attributes:
        servos: what is known of them.
        is_stuck: the answer to a motion is late and still waited for.
    """

    def __init__(
        self,
        client: AracnaClient,
        presence: LivenessMonitor,
        waiting: RequestQueue,
        player: SequencePlayer,
        tell: Callable[[Report], None],
    ) -> None:
        self.servos = Servos(0)
        self.is_stuck = False
        self._client = client
        self._presence = presence
        self._waiting = waiting
        self._player = player
        self._tell = tell

    def drop(self, now: float, why: Ending, reason: StudioError) -> None:
        """Let nothing of what waits be sent; what is on its way goes on where it can."""
        if why is not Ending.HALTED:
            self._waiting.answer(error=reason)
        self._player.stop(now, why, None if why is Ending.HALTED else reason)
        self._waiting.drop(reason)

    def hear(self, news: list[News]) -> None:
        """Take what has come of what was sent."""
        for one in news:
            match one:
                case Answered():
                    self._presence.note_answer(one.time)
                    self._note_answer(one)
                case Passing(present=present, time=time):
                    self._presence.note_answer(time)
                    self._tell(Passed(time, present))
                case LateReply(motor=motor, time=time):
                    self._note_late(motor, time)
                case Lost():
                    self._note_loss(one)
                case Voided(asked=asked, time=time):
                    self._note_restart(asked, time)

    def _note_late(self, motor: int | None, now: float) -> None:
        """What waits is not to begin by itself when a servo comes back, perhaps in an hour."""
        self.is_stuck = True
        self.servos.forget_speeds()  # a servo without power forgets its own
        self._tell(Stuck(now, motor))
        self._player.stop(now, Ending.STUCK, why_stuck(motor))
        self._waiting.drop(NoReply(STUCK))

    def _note_answer(self, answer: Answered) -> None:
        asked, now = answer.asked, answer.time
        self.is_stuck = False
        match answer.reply:
            case Version():
                self._note_version(answer.reply, now)
            case Speeds(values=held):
                self.servos.hold(held, now)
                report = SpeedsHeld(now, asked.values, held)
                self._tell(report)
                self._go_on_at(report)
            case Positions(values=present):
                self.servos.arrive(asked.values, present, now)
                moved = Moved(now, asked.values, present, now - asked.sent)
                self._tell(moved)
                self._player.arrive()
                if off := missed(asked.values, present):
                    self._player.stop(now, Ending.MISSED, why_missed(off))
                self._waiting.answer(moved)
            case Led(on=on):
                self._waiting.answer(on)

    def _go_on_at(self, report: SpeedsHeld) -> None:
        """Let a motion begin only where every servo has taken its speed."""
        error = why_not_taken(report.wanted, report.held)
        if self._waiting.is_preparing:
            if error is None:
                self._waiting.go_on()
            else:
                self._waiting.answer(error=error)
        elif not self._waiting.answer(report) and error is not None:
            self._player.stop(report.time, Ending.SPEEDS, error)

    def _note_version(self, reply: Version, now: float) -> None:
        motors = motors_of(reply)
        was_restarted = self._presence.was_restarted
        why = self._presence.be_there(now)
        if motors != self._client.motors:
            self._client.motors = motors
            self.servos = Servos(motors)
            if why in {None, QueryReason.UNSURE}:  # another robot: what was wished fits it no more
                self.drop(now, Ending.LOST, NoReply("Another robot answers now."))
                why = QueryReason.SILENT
        if why not in {None, QueryReason.UNSURE}:
            restarted = was_restarted and why is not QueryReason.OPENING
            self._tell(Connected(reply.version, motors, self._client.settings, restarted))

    def _note_loss(self, loss: Lost) -> None:
        if loss.asked.letter == "q":
            self._presence.retry(loss.time)
            self._presence.doubt(loss.time)
            if self._presence.is_over(loss.time):
                self.fall_silent(loss.error)
            return
        if loss.asked.letter == "c":  # nobody is to wait for its end any more
            self.is_stuck = False
            goals = loss.asked.values
            nowhere = (UNREAD,) * len(goals)
            self._tell(Moved(loss.time, goals, nowhere, loss.time - loss.asked.sent))
        if loss.asked.letter in {"c", "v"}:
            self.servos.forget_speeds()
        is_preparing = self._waiting.is_preparing
        self._waiting.answer(error=why_not_confirmed(loss.error) if is_preparing else loss.error)
        self._player.stop(loss.time, Ending.LOST, loss.error)
        if not loss.free:
            self._presence.doubt(loss.time)

    def _note_restart(self, asked: Sent | None, now: float) -> None:
        is_opening = self._presence.why is QueryReason.OPENING
        self.is_stuck = False
        self._presence.restart(now)
        if is_opening:
            return
        voided = self._player.is_playing or bool(self._waiting)
        voided |= asked is not None and asked.letter != "q"
        # The servos keep position and speed over a reset, but not over a power cut, and `.h` is
        # all that is seen of either.
        self.servos.forget()
        self._tell(Restarted(now, voided))
        self.drop(now, Ending.RESTARTED, StudioError("The robot's board has restarted."))

    def fall_silent(self, error: StudioError) -> None:
        """Call the robot silent; one that has never answered is none.

        Raises:
            NoReply, BadReply: it has never answered; says what to look at.
        """
        if self._presence.why is QueryReason.OPENING:
            raise diagnose(self._client.settings, self._client.received)
        self._presence.fall_silent(self._client.transport.clock())
        self.servos.forget()
        self._tell(NotResponding(str(error)))
        self.drop(
            self._client.transport.clock(), Ending.LOST, NoReply("The robot has stopped answering.")
        )
