"""The loop that owns a line to the robot: messages in, reports out, one command in flight.

It knows neither threads nor Qt. Nothing is sent unasked but `.q`: the one line that is harmless to
a TReX at any settings as well, which may be what is on the port. (With a newline before it, one at
38400 baud with odd parity may take both for an order.) There is no stop on this link: what `Halt`
can do is to send nothing more.
"""

import logging
from collections.abc import Callable
from typing import Protocol

from trex_gui.core.errors import BadRequest, NoReply, StudioError
from trex_gui.core.session.messages import Close, Closed
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol import lines
from trex_gui.devices.aracna.session.client import LINE, AracnaClient
from trex_gui.devices.aracna.session.joint_limits import GoalLimits
from trex_gui.devices.aracna.session.liveness import RETRY, LivenessMonitor, QueryReason
from trex_gui.devices.aracna.session.messages import (
    Drag,
    Ending,
    EndPlay,
    Halt,
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
from trex_gui.devices.aracna.session.rejections import STUCK
from trex_gui.devices.aracna.session.reply_handler import ReplyHandler
from trex_gui.devices.aracna.session.request_queue import Job, RequestQueue
from trex_gui.devices.aracna.session.servos import FRESH, TRUST, deadline
from trex_gui.devices.aracna.session.stats import StatsReporter

log = logging.getLogger(__name__)

_SLICE = 0.02
"""Seconds that an answer is waited for before requests are looked at."""

_REST = 0.05
"""Seconds that requests are waited for before the line is looked at: a `.h` may come."""

_TICK = 1e-5


class Inbox(Protocol):
    """Where requests come from."""

    def get(self, seconds: float) -> Request | None:
        """Return the next request, waiting up to `seconds` for one; else `None`."""
        ...


class _Closing(Exception):  # noqa: N818 - no error: the session was asked to end
    pass


class AracnaSession:
    """Serves one line from opening it to giving it back.

    `tell` is called with every report, from wherever `run` runs.
    """

    def __init__(
        self,
        settings: PortSettings,
        inbox: Inbox,
        tell: Callable[[Report], None],
        open_transport: Callable[[PortSettings], Transport] = SerialTransport,
    ) -> None:
        self._settings = settings.at(LINE)
        self._inbox = inbox
        self._tell = tell
        self._open_transport = open_transport
        self._goal_limits = GoalLimits()
        self._waiting = RequestQueue(tell, self._now)
        self._player = SequencePlayer(tell, self._goal_limits)

    def run(self) -> None:
        """Serve the line until it is lost or `Close` comes; then report `Closed`.

        Never raises: whatever happens, the port is given back and every request gets its
        outcome.
        """
        error: StudioError | None = None
        client: AracnaClient | None = None
        try:
            client = self._client = AracnaClient(
                self._open_transport(self._settings), self._settings
            )
            presence = self._presence = LivenessMonitor(self._now())
            self._hearing = ReplyHandler(client, presence, self._waiting, self._player, self._tell)
            counting = StatsReporter(client, self._tell)
            while True:
                self._step()
                counting.look(self._now())
        except _Closing:
            pass
        except StudioError as reason:
            error = reason
        except BaseException as reason:  # whatever ends this thread, the port is given back
            log.exception("the line session failed")
            error = StudioError(f"The program made a mistake on this line: {reason!r}")
        if client is not None:
            client.close()
        self._finish(error, client)

    def _finish(self, error: StudioError | None, client: AracnaClient | None) -> None:
        reason = error or StudioError("The line was closed before this was done.")
        while (request := self._inbox.get(0.0)) is not None:
            self._waiting.refuse(request, reason)
        if client is not None:
            self._hearing.drop(client.transport.clock(), Ending.LOST, reason)
        self._tell(Closed(error))

    def _now(self) -> float:
        return self._client.transport.clock()

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        if self._client.asked is not None:
            self._collect(0.0)
            self._hearing.hear(self._client.listen(_SLICE))
            return
        self._collect(max(_TICK, min(self._seconds_to_wait(), _REST)))
        self._hearing.hear(self._client.listen())
        if self._client.asked is None:
            self._serve()

    def _seconds_to_wait(self) -> float:
        now = self._now()
        seconds = self._presence.seconds_to_next(now)
        if self._presence.why is None:
            if self._waiting.has_more:
                return 0.0
            seconds = min(seconds, self._player.seconds_to_next(now))
        return seconds

    def _serve(self) -> None:
        """Send what is to be sent next."""
        now = self._now()
        presence = self._presence
        if presence.is_over(now):
            self._hearing.fall_silent(NoReply("The robot does not answer."))
        elif presence.why is not None:
            if presence.is_due(now):
                self._client.query(RETRY)
        elif self._waiting.has_jobs:  # asked for before what is played, so sent before it
            self._waiting.send(self._send)
        elif self._player.is_due(now):
            self._play(now)
        elif self._waiting.drag is not None:
            self._waiting.send_drag(self._send)
        elif presence.is_due(now):
            self._client.query()

    # --- Requests -----------------------------------------------------------------------

    def _collect(self, seconds: float) -> None:
        request = self._inbox.get(seconds)
        while request is not None:
            if isinstance(request, Close):
                raise _Closing
            self._take(request)
            request = self._inbox.get(0.0)

    def _take(self, request: Request) -> None:
        try:
            match request:
                case Halt():
                    self._hearing.drop(
                        self._now(), Ending.HALTED, StudioError("Halted before it was sent.")
                    )
                case Drag():
                    self._take_drag(request)
                case SetLimits(limits=limits):
                    self._goal_limits.set(limits)
                case EndPlay():
                    self._player.end()
                case SetTimeScale(time_scale=scale):
                    self._player.scale(scale)
                case Play():
                    self._check_presence()
                    self._refuse_while_playing()
                    self._refuse_while_stuck()
                    self._waiting.drop_drag()
                    self._player.start(request, self._hearing.servos, self._now())
                case Move():
                    self._check_presence()
                    self._refuse_while_playing()
                    self._refuse_while_stuck()
                    self._waiting.add(request)
                case SetSpeeds():
                    self._check_presence()
                    self._refuse_while_playing()
                    self._refuse_while_stuck()
                    self._waiting.add(request)
                case SetLed():
                    self._check_presence()
                    self._waiting.add(request)
                case _:
                    pass
        except (BadRequest, NoReply) as error:
            self._waiting.refuse(request, error)

    def _take_drag(self, drag: Drag) -> None:
        if not self._is_there or self._player.is_playing:
            return
        if self._hearing.is_stuck:
            self._waiting.refuse_drag(drag, NoReply(STUCK))
        else:
            self._waiting.drag = drag

    @property
    def _is_there(self) -> bool:
        return self._presence.why in {None, QueryReason.UNSURE}

    def _check_presence(self) -> None:
        if not self._is_there:
            raise NoReply("The robot does not answer yet; it is being asked.")

    def _refuse_while_playing(self) -> None:
        if self._player.is_playing:
            raise BadRequest("A sequence is being played: end it first.")

    def _refuse_while_stuck(self) -> None:
        if self._hearing.is_stuck:
            raise NoReply(STUCK)

    # --- Sending ------------------------------------------------------------------------

    def _send(self, job: Job | Drag) -> bool:
        """Send a job, or the speeds of a motion that the servos are not known to hold.

        Returns whether it was those, so that the motion is still to be sent.

        Raises:
            BadRequest: it has not one value of 0-1023 for each motor.
            PortUnavailable: the line is gone.
        """
        match job:
            case Move(goals=goals, speeds=speeds) | Drag(goals=goals, speeds=speeds):
                trust = FRESH if isinstance(job, Move) else TRUST
                self._hearing.servos.doubt(self._now(), trust)
                if speeds is not None and speeds != self._hearing.servos.speeds:
                    lines.positions(
                        self._goal_limits.crop(goals), self._client.motors
                    )  # refused first
                    self._client.set_speeds(speeds)
                    return True
                self._move(goals)
            case SetSpeeds(speeds=speeds):
                self._client.set_speeds(speeds)
            case SetLed(on=on):
                self._client.set_led(on=on)
        return False

    def _move(self, goals: tuple[int, ...]) -> None:
        """Send every motor to a goal.

        Raises:
            BadRequest: not one of 0-1023 for each.
            PortUnavailable: the line is gone.
        """
        goals = self._goal_limits.crop(goals)
        fits = len(goals) == self._client.motors
        expected = self._hearing.servos.seconds_to(goals) if fits else 0.0
        self._client.move(goals, deadline(expected))
        starts = self._hearing.servos.present
        self._hearing.servos.forget_positions()
        self._tell(Moving(self._now(), goals, starts, expected))

    def _play(self, now: float) -> None:
        """Send what the step that is due needs next."""
        self._hearing.servos.doubt(now)
        if (speeds := self._player.take_speeds(now, self._hearing.servos)) is not None:
            self._client.set_speeds(speeds)
        elif (goals := self._player.take_goals()) is not None:
            self._move(goals)
