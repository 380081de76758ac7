"""Player of a sequence of steps.

The schedule does not drift: a step is due when the previous steps should have ended. The duration
of a step includes the time for `.v`, `.c` and their replies. If the robot is too slow, the next
step starts late and is shortened by at most half of its duration.
"""

import itertools
import math
from collections.abc import Callable, Iterator, Sequence

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.session import Outcome
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.protocol.joints import HIGHEST
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Play,
    PlayEnded,
    Report,
    Step,
    StepStarted,
)
from trex_gui.devices.aracna.session.servo_estimates import ServoEstimates

REPLY_TIME = 0.04  # duration in seconds of a `.c` without motion: 33 to 37 ms on a wire
_MIN_FRACTION = 0.5  # minimum fraction of a late step's duration that is left for its motion
_TIME_SCALES = (0.05, 20.0)  # minimum and maximum


ScheduledStep = tuple[str, int, int, Step]
"""Part of the sequence (`in`, `steps` or `out`), index in the part, round, and step."""


def check_play(play: Play, motors: int) -> None:
    """Raise BadRequest for a sequence that the robot cannot play."""
    steps = (*play.blend_in, *play.steps, *play.blend_out)
    is_valid = (
        ((play.rounds > 0 and bool(steps)) or (play.rounds == 0 and bool(play.steps)))
        and _is_scale(play.time_scale)
        and all(0 < step.seconds < math.inf for step in steps)
        and all(0 <= goal <= HIGHEST for step in steps for goal in step.goals)
    )
    if not is_valid or any(len(step.goals) != motors for step in steps):
        raise BadRequest(tr("A robot with {0} motors cannot play this sequence.").format(motors))


def _is_scale(time_scale: float) -> bool:
    return _TIME_SCALES[0] <= time_scale <= _TIME_SCALES[1]


def _schedule(play: Play) -> Iterator[ScheduledStep]:
    yield from _numbered("in", play.blend_in)
    rounds = range(play.rounds) if play.rounds else itertools.count()
    for number in rounds if play.steps else ():
        yield from _numbered("steps", play.steps, number)
    yield from _numbered("out", play.blend_out)


def _numbered(part: str, steps: Sequence[Step], number: int = 0) -> Iterator[ScheduledStep]:
    return ((part, index, number, step) for index, step in enumerate(steps))


class SequencePlayer:
    def __init__(self, report: Callable[[Report], None], servos: ServoEstimates) -> None:
        self._report = report
        self.servos = servos
        self._play: Play | None = None
        self._goals: tuple[int, ...] | None = None  # unsent goals of the running step
        self._is_moving = False

    @property
    def is_playing(self) -> bool:
        return self._play is not None

    def start(self, play: Play, now: float) -> None:
        check_play(play, len(self.servos.speeds))
        self._play, self._time_scale = play, play.time_scale
        self._steps = _schedule(play)
        self._due = now  # start of the next step
        self._part = ""  # part of the running step
        self._is_ending = False
        self._speeds_before: tuple[int, ...] | None = None  # restored at the end
        self._goals, self._is_moving = None, False

    def end(self) -> None:
        """End the sequence after the running step, with the blend-out."""
        if self._play is None:
            return
        self._is_ending = True
        if self._part != "out":
            self._steps = _numbered("out", self._play.blend_out)

    def set_time_scale(self, time_scale: float) -> None:
        if _is_scale(time_scale):
            self._time_scale = time_scale

    def stop(self, now: float, ending: Ending, error: StudioError | None = None) -> None:
        play, self._play = self._play, None
        self._goals, self._is_moving = None, False
        if play is not None:
            self._report(PlayEnded(now, ending))
            self._report(Outcome(play.id, None if error else ending, error))

    def seconds_to_next(self, now: float) -> float:
        """Return the seconds until the next command. Infinite if no command is scheduled."""
        if self._play is None or self._is_moving:
            return math.inf
        return 0.0 if self._goals is not None else max(0.0, self._due - now)

    def next_speeds(self, now: float) -> tuple[int, ...] | None:
        """Start the step that is due. Return its speeds if they must be set.

        After the last step, return the speeds that the servos reported before the sequence. Without
        them, the next move could take minutes, because the last step may have set very low speeds.
        """
        if self._play is None or self._goals is not None:
            return None
        if (scheduled := next(self._steps, None)) is None:
            before, self._speeds_before = self._speeds_before, None
            if before not in {None, self.servos.speeds}:
                return before
            self.stop(now, Ending.ENDED if self._is_ending else Ending.DONE)
            return None
        if not self._part:  # before the first step, all earlier requests have been sent
            self._speeds_before = self.servos.reported_speeds
            self._due = now
        self._part, index, number, step = scheduled
        seconds, late = step.seconds * self._time_scale, max(0.0, now - self._due)
        if late > seconds:  # too late to catch up
            self._due = now
        self._due += seconds
        self._goals = self.servos.clamp(step.goals)
        self._report(StepStarted(now, self._part, index, number, late))
        # Leaves time for the `.c`. `speeds_to` leaves time for the `.v`.
        remaining = max(self._due - now - REPLY_TIME, seconds * _MIN_FRACTION)
        return self.servos.speeds_to(self._goals, remaining)

    def next_goals(self) -> tuple[int, ...] | None:
        """Return the running step's unsent goals, or `None`. Its speeds must already be set."""
        goals, self._goals = self._goals, None
        self._is_moving = goals is not None
        return goals

    def on_arrival(self) -> None:
        self._is_moving = False
