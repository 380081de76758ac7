"""Which step of a sequence is due when: steps on a clock that does not drift. Pure.

A step is due when those before it should have been over, not when they were: what `.v`, `.c`
and their answers take is no part of a step's seconds, so a step has that much less to move in.
Where the robot cannot keep up, the next step begins late, says how much, and tries to make up
for it; by no more than half of its seconds, so that nothing runs away.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.protocol.units import HIGHEST
from trex_gui.devices.aracna.session.messages import Play, Step

ANSWERING = 0.04
"""Seconds that a `.c` takes without any motion: 33 to 37 ms on a wire."""

_SHORTEST = 0.5
"""Part of a step's seconds that are left for its motion, however late it begins."""

_SCALES = (0.05, 20.0)


@dataclass(frozen=True, slots=True)
class Turn:
    """A step and where it stands: `part` is one of `in`, `steps`, `out`."""

    part: str
    index: int
    round: int
    step: Step


def check(play: Play, motors: int) -> None:
    """Refuse what cannot be played on so many motors.

    Raises:
        BadRequest: says what and what is allowed.
    """
    if not (play.steps or play.blend_in or play.blend_out):
        raise BadRequest("There is no step to play.")
    if play.rounds < 0:
        raise BadRequest(f"The number of rounds is 0 (for ever) or more, not {play.rounds}.")
    if not play.steps and play.rounds == 0:
        raise BadRequest("Nothing can be played for ever: there is no step.")
    check_scale(play.time_scale)
    for step in (*play.blend_in, *play.steps, *play.blend_out):
        name = f" ({step.name})" if step.name else ""
        if len(step.goals) != motors:
            raise BadRequest(
                f"A step{name} has {len(step.goals)} positions; the robot has {motors} motors."
            )
        if not all(0 <= goal <= HIGHEST for goal in step.goals):
            raise BadRequest(f"The positions of a step{name} are 0 to {HIGHEST}: {step.goals}.")
        if not (math.isfinite(step.seconds) and step.seconds > 0):
            raise BadRequest(f"A step{name} takes more than 0 s, not {step.seconds:g} s.")


def check_scale(scale: float) -> None:
    """Refuse a time scale that makes no sense.

    Raises:
        BadRequest: it is not between 0.05 and 20.
    """
    low, high = _SCALES
    if not low <= scale <= high:
        raise BadRequest(f"The time scale is {low:g} to {high:g}, not {scale:g}.")


class StepClock:
    """What is played, from the first step to the last.

    Attributes:
        play: what was asked for.
        time_scale: factor on the seconds of every step that begins from now on.
        due: when the next step is to begin, on the line's clock.
        turn: the step that runs; `None` before the first.
    """

    def __init__(self, play: Play, now: float) -> None:
        self.play = play
        self.time_scale = play.time_scale
        self.due = now
        self.turn: Turn | None = None
        self._ends = False

    @property
    def was_ended(self) -> bool:
        """Whether it was asked to end after a step."""
        return self._ends

    def end(self) -> None:
        """Go on with the blend-out after the step that runs."""
        self._ends = True

    def next(self) -> Turn | None:
        """Return the step that comes next; `None` when it is over."""
        return self._ended(self.turn) if self._ends else self._after(self.turn)

    def begin(self, turn: Turn, now: float) -> tuple[float, float]:
        """Begin a step; return how late that is, and how long its motion may take, in seconds.

        What a `.c` takes by itself is taken off; a `.v` that is needed is not.
        """
        seconds = turn.step.seconds * self.time_scale
        if self.turn is None:  # what was asked for before it has gone before it
            self.due = now
        late = max(0.0, now - self.due)
        if late > seconds:  # it would run after its clock for ever
            self.due = now
        self.turn = turn
        self.due += seconds
        return late, max(self.due - now - ANSWERING, seconds * _SHORTEST)

    def _ended(self, turn: Turn | None) -> Turn | None:
        if turn is not None and turn.part == "out":
            return self._in("out", self.play.blend_out, turn.index + 1)
        return self._in("out", self.play.blend_out, 0)

    def _after(self, turn: Turn | None) -> Turn | None:
        play = self.play
        if turn is None:
            return self._in("in", play.blend_in, 0) or self._round(0) or self._ended(None)
        if turn.part == "in":
            return (
                self._in("in", play.blend_in, turn.index + 1) or self._round(0) or self._ended(None)
            )
        if turn.part == "out":
            return self._ended(turn)
        if following := self._in("steps", play.steps, turn.index + 1, turn.round):
            return following
        return self._round(turn.round + 1) or self._ended(None)

    def _round(self, number: int) -> Turn | None:
        if self.play.rounds and number >= self.play.rounds:
            return None
        return self._in("steps", self.play.steps, 0, number)

    def _in(self, part: str, steps: Sequence[Step], index: int, number: int = 0) -> Turn | None:
        return Turn(part, index, number, steps[index]) if index < len(steps) else None
