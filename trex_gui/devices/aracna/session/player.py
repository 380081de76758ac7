"""Playing on the line: for each step the speeds, the goals, and the wait for both."""

import math
from collections.abc import Callable

from trex_gui.core.errors import StudioError
from trex_gui.core.session.messages import Outcome
from trex_gui.devices.aracna.session.joint_limits import GoalLimits
from trex_gui.devices.aracna.session.messages import Ending, Play, PlayEnded, Report, StepBegun
from trex_gui.devices.aracna.session.servos import Servos
from trex_gui.devices.aracna.session.step_clock import StepClock, check, check_scale


class SequencePlayer:
    """What is played at the moment, and where its step is: speeds, then goals, then arrived."""

    def __init__(self, tell: Callable[[Report], None], goal_limits: GoalLimits) -> None:
        self._tell = tell
        self._goal_limits = goal_limits
        self._playing: StepClock | None = None
        self._goals: tuple[int, ...] | None = None  # of the step that runs, not yet sent
        self._waits = False  # for the answer to them
        self._before: tuple[int, ...] | None = None  # speeds to give back in the end

    @property
    def is_playing(self) -> bool:
        """Whether anything is."""
        return self._playing is not None

    def start(self, play: Play, servos: Servos, now: float) -> None:
        """Begin.

        Raises:
            BadRequest: it cannot be played on so many motors.
        """
        check(play, len(servos.speeds))
        self._before = None
        self._playing = StepClock(play, now)
        self._goals, self._waits = None, False

    def end(self) -> None:
        """End after the step that runs, with the blend-out."""
        if self._playing is not None:
            self._playing.end()

    def scale(self, time_scale: float) -> None:
        """Take another time scale from the next step on; one that makes no sense is not taken.

        Raises:
            BadRequest: it is out of range.
        """
        check_scale(time_scale)
        if self._playing is not None:
            self._playing.time_scale = time_scale

    def stop(self, now: float, why: Ending, error: StudioError | None = None) -> None:
        """Play nothing any more, and tell it."""
        playing, self._playing = self._playing, None
        self._goals, self._waits = None, False
        if playing is not None:
            self._tell(PlayEnded(now, why))
            self._tell(Outcome(playing.play.id, None if error else why, error))

    # --- The line is free ---------------------------------------------------------------

    def seconds_to_next(self, now: float) -> float:
        """Return how long there is nothing to send; infinity while nothing is played."""
        if self._playing is None or self._waits:
            return math.inf
        return 0.0 if self._goals is not None else max(0.0, self._playing.due - now)

    def is_due(self, now: float) -> bool:
        """Whether there is something to send, or it is over."""
        return self.seconds_to_next(now) <= 0

    def take_speeds(self, now: float, servos: Servos) -> tuple[int, ...] | None:
        """Begin the step that is due; return the speeds it needs where others are set.

        `None` where they are right, where a step has begun already, or where it is all over. In
        the end the servos get the speeds back that they had before: a person's next move must not
        take minutes because a motor had next to nothing to do in the last step.
        """
        if self._playing is None or self._goals is not None:
            return None
        if (turn := self._playing.next()) is None:
            before, self._before = self._before, None
            if before not in {None, servos.speeds}:
                return before
            self.stop(now, Ending.ENDED if self._playing.was_ended else Ending.DONE)
            return None
        if self._playing.turn is None:  # speeds that were asked for before are set by now
            speeds = tuple(speed for speed in servos.speeds if speed is not None)
            self._before = speeds if len(speeds) == len(servos.speeds) else None
        late, seconds = self._playing.begin(turn, now)
        self._goals = self._goal_limits.crop(turn.step.goals)
        self._tell(StepBegun(now, turn.part, turn.index, turn.round, late))
        return servos.speeds_to(self._goals, seconds)

    def take_goals(self) -> tuple[int, ...] | None:
        """Return where the step goes, its speeds being set; `None` where nothing is to be sent."""
        goals, self._goals = self._goals, None
        self._waits = goals is not None
        return goals

    def arrive(self) -> None:
        """The answer to the goals is there."""
        self._waits = False
