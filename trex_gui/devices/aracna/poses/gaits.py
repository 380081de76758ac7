"""Built-in poses and gaits.

Ref: CreativeMachinesLab/aracna:

- `RobotPi/PiConstants.py`: poses with one inner and one outer position for all legs. Several
  positions are outside the joints' limits.
- `RobotPi/commonGaits.py`: gaits. A gait is a loop of poses with durations, linearly interpolated.
- `RobotPi/RobotPi.py`: 3 s to flat, then 3 s to stand.

Gaits marked `ours` use the authors' poses, but were not made by the authors. All poses are clamped
to the limits that were tuned on the robot. The authors' programs also clamp goals.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from trex_gui.core.translation import tr_noop
from trex_gui.devices.aracna.poses.project import Pose, Sequence, SequenceStep
from trex_gui.devices.aracna.protocol.joints import MOTORS, clamp, factory_limits

SLOW_SECONDS = 3.0  # the authors' robot takes 3 s to lie flat, and 3 s to stand up


def all_legs(name: str, inner: int, outer: int) -> Pose:
    """Return a pose with equal positions for all legs. Even motors are inner joints."""
    return _within_limits(name, (inner, outer) * (MOTORS // 2))


def _within_limits(name: str, positions: Iterable[float]) -> Pose:
    return Pose(name, clamp(positions, factory_limits()))


FLAT = all_legs("flat", 770, 40)
HALF_STAND = all_legs("half-stand", 700, 100)
STAND = all_legs("stand", 512, 680)
SELF_TEST_A = all_legs("self-test a", 770, 200)
SELF_TEST_B = all_legs("self-test b", 670, 300)

BUILT_IN_POSES = (
    FLAT,
    HALF_STAND,
    STAND,
    all_legs("up-1", 0, 600),
    all_legs("up-2", 600, 600),
    SELF_TEST_A,
    SELF_TEST_B,
)


@dataclass(frozen=True, slots=True)
class Gait(Sequence):
    """Sequence of at least one step, with its own poses."""

    poses: tuple[Pose, ...] = ()
    about: str = ""
    cyclic: bool = True  # True if the first step starts in the last pose
    ours: bool = False  # True if not made by the robot's authors


def _gait(
    name: str, about: str, *stages: tuple[Pose, float], cyclic: bool = True, ours: bool = False
) -> Gait:
    """Create a gait. A stage is a pose and the seconds to reach it."""
    steps = tuple(SequenceStep(pose.name, round(1000 * seconds)) for pose, seconds in stages)
    return Gait(name, steps, tuple(pose for pose, _ in stages), about, cyclic, ours)


_NEUTRAL = 300
_LIFT = 200
_SWING = 300


def _star(swung: int) -> Gait:
    """Create a star gait. The outer joint of leg `swung` (0-3) first swings to a lower position.

    The authors number a star gait by the inner motor of this leg. They define gaits 2 and 6. Gaits
    0 and 4, for the neighbouring legs, are inferred.
    """
    opposite = (swung + 2) % 4
    standing = ((swung + 1) % 4, (swung + 3) % 4)

    def pose(name: str, lifted: tuple[int, int], sign: int) -> Pose:
        positions = [_NEUTRAL] * MOTORS
        for leg in lifted:
            positions[2 * leg] -= _LIFT
        positions[2 * swung + 1] -= sign * _SWING
        positions[2 * opposite + 1] += sign * _SWING
        return _within_limits(name, positions)

    swinging = (swung, opposite)
    return _gait(
        f"star {2 * swung}",
        tr_noop(
            "Lifts two opposite legs, swings the other two, changes over and swings them back."
        ),
        (pose("swing", standing, 1), 0.5),
        (pose("change over", swinging, 1), 0.2),
        (pose("swing back", swinging, -1), 0.5),
        (pose("change back", standing, 0), 0.2),
    )


def _sine() -> Gait:
    period, samples, stages = 2 * math.pi, 16, []
    for number in range(1, samples + 1):
        position = 512 + 100 * math.sin(period * number / samples)
        pose = _within_limits(f"{number} of {samples}", (position,) * MOTORS)
        stages.append((pose, period / samples))
    return _gait(
        "sine",
        tr_noop("Moves all motors together, up to 100 units to either side of the centre."),
        *stages,
    )


STAND_UP = _gait(
    "stand up",
    tr_noop("Lies down flat in 3 s and stands up in 3 s, from any position."),
    (FLAT, SLOW_SECONDS),
    (STAND, SLOW_SECONDS),
    cyclic=False,
)

GAITS = (
    STAND_UP,
    *(_star(leg) for leg in range(4)),
    _sine(),
    _gait(
        "self-test",
        tr_noop(
            "Moves back and forth between two poses; a motor that ends more than 50 units "
            "from its goal is suspect."
        ),
        (SELF_TEST_A, 1.0),
        (SELF_TEST_B, 1.0),
    ),
    _gait(
        "push-ups",
        tr_noop("Moves down to half-stand and up again."),
        (HALF_STAND, 1.0),
        (STAND, 1.0),
        ours=True,
    ),
    _gait(
        "lie down",
        tr_noop("Moves through half-stand to flat, from any position."),
        (HALF_STAND, 2.0),
        (FLAT, 2.0),
        cyclic=False,
        ours=True,
    ),
)
