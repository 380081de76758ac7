"""Playing a sequence: which step is due when, its speeds, its goals, and waiting for arrival.

Steps run on a clock that does not drift. A step is due when the ones before it should have ended,
not when they did: the time for `.v`, `.c` and their replies counts towards a step's seconds. If the
robot cannot keep up, the next step starts late and is shortened, by half its seconds at most.
"""

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

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
    StepBegun,
)
from trex_gui.devices.aracna.session.servo_estimates import ServoEstimates

REPLY_TIME = 0.04  # seconds that a `.c` takes without any motion: 33 to 37 ms on a wire
_SHORTEST = 0.5  # part of a step's seconds that is left for its motion, however late it starts
_SCALES = (0.05, 20.0)


@dataclass(frozen=True, slots=True)
class ScheduledStep:
    """A step and its place: `part` is `in`, `steps` or `out`."""

    part: str
    index: int
    round: int
    step: Step


def check_play(play: Play, motors: int) -> None:
    """Raise a BadRequest for no steps, a wrong number of positions, or values out of range."""
    steps = (*play.blend_in, *play.steps, *play.blend_out)
    is_possible = (
        ((play.rounds > 0 and bool(steps)) or (play.rounds == 0 and bool(play.steps)))
        and _is_scale(play.time_scale)
        and all(0 < step.seconds < math.inf for step in steps)
        and all(0 <= goal <= HIGHEST for step in steps for goal in step.goals)
    )
    if not is_possible or any(len(step.goals) != motors for step in steps):
        raise BadRequest(tr("A robot with {0} motors cannot play this.").format(motors))


def _is_scale(time_scale: float) -> bool:
    return _SCALES[0] <= time_scale <= _SCALES[1]


def _schedule(play: Play) -> Iterator[ScheduledStep]:
    yield from _numbered("in", play.blend_in)
    rounds = range(play.rounds) if play.rounds else itertools.count()
    for number in rounds if play.steps else ():
        yield from _numbered("steps", play.steps, number)
    yield from _numbered("out", play.blend_out)


def _numbered(part: str, steps: Sequence[Step], number: int = 0) -> Iterator[ScheduledStep]:
    return (ScheduledStep(part, index, number, step) for index, step in enumerate(steps))


class StepClock:
    """Schedules the steps of a sequence; `due` is the next one's start, on the line's clock."""

    def __init__(self, play: Play, now: float) -> None:
        self.play = play
        self.time_scale = play.time_scale
        self.due = now
        self.current: ScheduledStep | None = None
        self.is_ending = False
        self._steps = _schedule(play)

    def end(self) -> None:
        """Let only the blend-out follow the running step."""
        self.is_ending = True
        if self.current is None or self.current.part != "out":
            self._steps = _numbered("out", self.play.blend_out)

    def next(self) -> ScheduledStep | None:
        return next(self._steps, None)

    def start(self, step: ScheduledStep, now: float) -> tuple[float, float]:
        """Start a step; return by how much it is late, and the time for its motion, in seconds.

        The time excludes what a `.c` takes by itself, but not a `.v`.
        """
        seconds = step.step.seconds * self.time_scale
        if self.current is None:  # requests queued earlier have been sent by now
            self.due = now
        late = max(0.0, now - self.due)
        if late > seconds:  # it could never catch up
            self.due = now
        self.current = step
        self.due += seconds
        return late, max(self.due - now - REPLY_TIME, seconds * _SHORTEST)


class SequencePlayer:
    """The playing sequence and the state of its step: speeds, then goals, then arrival."""

    def __init__(self, report: Callable[[Report], None], servos: ServoEstimates) -> None:
        self._report = report
        self.servos = servos
        self._clock: StepClock | None = None
        self._goals: tuple[int, ...] | None = None  # of the running step, not sent yet
        self._is_moving = False
        self._speeds_before: tuple[int, ...] | None = None  # to restore at the end

    @property
    def is_playing(self) -> bool:
        return self._clock is not None

    def start(self, play: Play, now: float) -> None:
        check_play(play, len(self.servos.speeds))
        self._speeds_before = None
        self._clock = StepClock(play, now)
        self._goals, self._is_moving = None, False

    def end(self) -> None:
        """End after the running step, with the blend-out."""
        if self._clock is not None:
            self._clock.end()

    def set_time_scale(self, time_scale: float) -> None:
        """Change the time scale from the next step on, unless it is out of range."""
        if self._clock is not None and _is_scale(time_scale):
            self._clock.time_scale = time_scale

    def stop(self, now: float, why: Ending, error: StudioError | None = None) -> None:
        clock, self._clock = self._clock, None
        self._goals, self._is_moving = None, False
        if clock is not None:
            self._report(PlayEnded(now, why))
            self._report(Outcome(clock.play.id, None if error else why, error))

    def seconds_to_next(self, now: float) -> float:
        """Return how long until something is to be sent; infinity while nothing plays."""
        if self._clock is None or self._is_moving:
            return math.inf
        return 0.0 if self._goals is not None else max(0.0, self._clock.due - now)

    def next_speeds(self, now: float) -> tuple[int, ...] | None:
        """Start the due step; return the speeds it needs if they are to be set.

        At the end these are the speeds from before: otherwise the next move could take minutes,
        because a motor hardly had to move in the last step.
        """
        if self._clock is None or self._goals is not None:
            return None
        if (step := self._clock.next()) is None:
            before, self._speeds_before = self._speeds_before, None
            if before not in {None, self.servos.speeds}:
                return before
            self.stop(now, Ending.ENDED if self._clock.is_ending else Ending.DONE)
            return None
        if self._clock.current is None:  # queued speeds have been set by now
            speeds = tuple(speed for speed in self.servos.speeds if speed is not None)
            self._speeds_before = speeds if len(speeds) == len(self.servos.speeds) else None
        late, seconds = self._clock.start(step, now)
        self._goals = self.servos.crop(step.step.goals)
        self._report(StepBegun(now, step.part, step.index, step.round, late))
        return self.servos.speeds_to(self._goals, seconds)

    def next_goals(self) -> tuple[int, ...] | None:
        """Return the goals of the step once its speeds are set; `None`: nothing to send."""
        goals, self._goals = self._goals, None
        self._is_moving = goals is not None
        return goals

    def on_arrival(self) -> None:
        self._is_moving = False
