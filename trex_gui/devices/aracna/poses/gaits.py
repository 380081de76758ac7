"""Gaits that come with the program: positions as a function of time.

Ref: CreativeMachinesLab/aracna `RobotPi/commonGaits.py` (a list of poses with a duration each,
linear in between, from the last one back to the first) and `RobotPi/RobotPi.py` (3 s to flat, then
3 s to stand). Those marked `ours` are made of the authors' poses, but are not theirs.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

from trex_gui.devices.aracna.poses.named_poses import (
    FLAT,
    HALF_STAND,
    SELF_TEST_A,
    SELF_TEST_B,
    STAND,
)
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS

SLOWLY = 3.0
"""Seconds in which the authors' robot goes to flat, and from there to stand."""


@dataclass(frozen=True, slots=True)
class GaitStage:
    """Reach a pose in so many seconds, more than 0."""

    pose: Pose
    seconds: float


@dataclass(frozen=True, slots=True)
class Gait:
    """Stages one after the other.

    Attributes:
        name: for people.
        stages: at least one.
        about: what it does, for people; a sentence.
        cyclic: the first stage begins where the last one ends, so it can go on for ever.
        ours: the robot's authors do not have it.
    """

    name: str
    stages: tuple[GaitStage, ...]
    about: str = ""
    cyclic: bool = True
    ours: bool = False

    @property
    def seconds(self) -> float:
        """How long all stages take together."""
        return sum(stage.seconds for stage in self.stages)

    @property
    def start(self) -> Pose | None:
        """Where it begins; `None` for one that begins wherever the robot is."""
        return self.stages[-1].pose if self.cyclic else None

    def at(self, time: float, time_scale: float = 1.0) -> tuple[float, ...]:
        """Return the positions at a time in seconds, linear between poses.

        A cyclic one begins anew after its last stage. Another one is taken to begin in its
        first pose and stays in its last. A `time_scale` of 2 is half as fast.
        """
        when = time / time_scale
        if self.cyclic:
            when %= self.seconds
        before = self.stages[-1 if self.cyclic else 0].pose.positions
        for stage in self.stages:
            if when < stage.seconds:
                share = max(when, 0.0) / stage.seconds
                pairs = zip(before, stage.pose.positions, strict=True)
                return tuple(start + (end - start) * share for start, end in pairs)
            when -= stage.seconds
            before = stage.pose.positions
        return tuple(map(float, before))


def sampled(
    name: str,
    motion: Callable[[float], tuple[float, ...]],
    seconds: float,
    samples: int,
    about: str,
) -> Gait:
    """Return the gait that goes through a periodic function of time at fixed times.

    What leaves 0-1023 is cut there.
    """
    stages = []
    for number in range(1, samples + 1):
        positions = motion(seconds * number / samples)
        cut = tuple(min(max(round(position), 0), HIGHEST) for position in positions)
        stages.append(GaitStage(Pose(f"{number} of {samples}", cut), seconds / samples))
    return Gait(name, tuple(stages), about)


_REST = 300
_LIFT = 200
_SWING = 300


def _star(swung: int) -> Gait:
    """Return the star gait in which the outer joint of leg `swung` (0-3) swings to its low end.

    The authors' number is that of the leg's inner motor. Theirs are 2 and 6; 0 and 4 are the
    same a leg further, as the names say (inferred).
    """
    opposite = (swung + 2) % 4
    standing = ((swung + 1) % 4, (swung + 3) % 4)

    def pose(name: str, lifted: tuple[int, int], sign: int) -> Pose:
        positions = [_REST] * MOTORS
        for leg in lifted:
            positions[2 * leg] -= _LIFT
        positions[2 * swung + 1] -= sign * _SWING
        positions[2 * opposite + 1] += sign * _SWING
        return Pose(name, tuple(positions))

    swinging = (swung, opposite)
    return Gait(
        f"star {2 * swung}",
        (
            GaitStage(pose("swing", standing, 1), 0.5),
            GaitStage(pose("change over", swinging, 1), 0.2),
            GaitStage(pose("swing back", swinging, -1), 0.5),
            GaitStage(pose("change back", standing, 0), 0.2),
        ),
        "Lifts two opposite legs, swings the other two, changes over and swings them back.",
    )


def _sine(time: float) -> tuple[float, ...]:
    return (512 + 100 * math.sin(time),) * MOTORS


STAND_UP = Gait(
    "stand up",
    (GaitStage(FLAT, SLOWLY), GaitStage(STAND, SLOWLY)),
    "Lies down flat in 3 s and stands up in 3 s, from wherever it is.",
    cyclic=False,
)

GAITS = (
    STAND_UP,
    *(_star(leg) for leg in range(4)),
    sampled("sine", _sine, 2 * math.pi, 16, "All motors together, 100 units about the centre."),
    Gait(
        "self-test",
        (GaitStage(SELF_TEST_A, 1.0), GaitStage(SELF_TEST_B, 1.0)),
        "To and fro between two poses; motors that stay more than 50 units off are suspect.",
    ),
    Gait(
        "push-ups",
        (GaitStage(HALF_STAND, 1.0), GaitStage(STAND, 1.0)),
        "Down to half-stand and up again.",
        ours=True,
    ),
    Gait(
        "lie down",
        (GaitStage(HALF_STAND, 2.0), GaitStage(FLAT, 2.0)),
        "Over half-stand to flat, from wherever it is.",
        cyclic=False,
        ours=True,
    ),
)
