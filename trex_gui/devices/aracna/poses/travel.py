"""How long steps take, and which motors cannot make it.

A servo without load needs its distance over its speed; nothing makes it faster than its ceiling.
"""

from collections.abc import Sequence as Many
from dataclasses import dataclass

from trex_gui.devices.aracna.protocol.units import CEILING, travel_seconds
from trex_gui.devices.aracna.session.messages import Step

Present = Many[int | None]
"""Where each motor is; `None` where nobody knows."""

TALK_SECONDS = 0.1
"""What a step costs on the line at least: `.v` and `.c` without motion, 42-55 and 33-37 ms."""


@dataclass(frozen=True, slots=True)
class Late:
    """A motor that cannot make a step in time.

    Attributes:
        step: index of the step, from 0.
        motor: 0-7.
        seconds: what the step gives it.
        needed: what it needs at its ceiling speed, without load.
    """

    step: int
    motor: int
    seconds: float
    needed: float


def late_motors(
    steps: Many[Step], start: Present = (), *, again: bool = False, ceiling: int = CEILING
) -> tuple[Late, ...]:
    """Return each motor that cannot make a step in time, even as fast as it can.

    From a place that is unknown every step is in time. With `again` the first step is also
    looked at from where the last one ends.
    """
    found = []
    if again and steps:
        found += _late_in(0, steps[0], steps[-1].goals, ceiling)
    before: Present = start
    for number, step in enumerate(steps):
        for late in _late_in(number, step, before, ceiling):
            if not any((one.step, one.motor) == (late.step, late.motor) for one in found):
                found.append(late)
        before = step.goals
    return tuple(found)


def estimated_seconds(steps: Many[Step], start: Present = (), *, ceiling: int = CEILING) -> float:
    """Return how long steps take in all: each its own time, or that of its slowest motor."""
    total = 0.0
    before: Present = start
    for step in steps:
        needed = [late.needed for late in _late_in(0, step, before, ceiling)]
        total += max(step.seconds, TALK_SECONDS, *needed)
        before = step.goals
    return total


def _late_in(number: int, step: Step, before: Present, ceiling: int) -> list[Late]:
    late = []
    for motor, (start, goal) in enumerate(zip(before, step.goals, strict=False)):
        if start is None:
            continue
        needed = travel_seconds(goal - start, 0, ceiling)
        if needed > step.seconds:
            late.append(Late(number, motor, step.seconds, needed))
    return late
