"""What a sequence or gait becomes when it is played: steps within the joints' limits."""

from collections.abc import Iterable
from collections.abc import Sequence as Many
from dataclasses import dataclass

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.poses.gaits import SLOWLY, Gait
from trex_gui.devices.aracna.poses.named_poses import STAND
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.project import missing_poses
from trex_gui.devices.aracna.poses.sequence import Sequence
from trex_gui.devices.aracna.poses.travel import Present
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.session.messages import Step

SLOWEST, FASTEST = 10.0, 0.1
"""Time scales that are offered: ten times as slow, ten times as fast."""


@dataclass(frozen=True, slots=True)
class Cropped:
    """A position that a joint may not take, and the nearest one that is sent instead."""

    step: int
    motor: int
    wanted: int
    sent: int


def steps_of(
    played: Sequence | Gait,
    poses: Iterable[Pose],
    limits: Many[Limits],
    time_scale: float = 1.0,
) -> tuple[Step, ...]:
    """Return the steps of a sequence or gait, each goal cropped to its joint's limits.

    `limits` has one entry a motor and says how many there are; positions that a pose lacks are
    512. Every time is multiplied by `time_scale`.

    Raises:
        BadRequest: there is nothing to play, it names poses that nobody has defined, or the
            time scale is not more than 0.
    """
    if not time_scale > 0:
        raise BadRequest(f"a time scale is more than 0, not {time_scale}")
    return tuple(
        Step(cropped(pose, limits), seconds * time_scale, pose.name)
        for pose, seconds in _stages(played, poses)
    )


def crops_of(
    played: Sequence | Gait, poses: Iterable[Pose], limits: Many[Limits]
) -> tuple[Cropped, ...]:
    """Return each position that `steps_of` crops, in the order of steps and motors.

    Raises:
        BadRequest: as of `steps_of`.
    """
    found = []
    for number, (pose, _) in enumerate(_stages(played, poses)):
        wanted = pose.first(len(limits))
        for motor, (want, sent) in enumerate(zip(wanted, cropped(pose, limits), strict=True)):
            if want != sent:
                found.append(Cropped(number, motor, want, sent))
    return tuple(found)


def cropped(pose: Pose, limits: Many[Limits]) -> tuple[int, ...]:
    """Return a pose's positions, one a motor, as they may be sent."""
    wanted = pose.first(len(limits))
    return tuple(limit.crop(position) for limit, position in zip(limits, wanted, strict=True))


def blend_in(
    played: Sequence | Gait,
    poses: Iterable[Pose],
    limits: Many[Limits],
    present: Present = (),
    seconds: float = SLOWLY,
) -> tuple[Step, ...]:
    """Return what leads slowly from where the robot is to where it begins.

    A gait that goes on for ever begins in its last pose, a sequence in its first one. Nothing
    is needed where the robot is there already, nor before a gait that begins anywhere.

    Raises:
        BadRequest: as of `steps_of`.
    """
    stages = _stages(played, poses)
    start = played.start if isinstance(played, Gait) else stages[0][0]
    if start is None:
        return ()
    goals = cropped(start, limits)
    return () if tuple(present) == goals else (Step(goals, seconds, start.name),)


def blend_out(
    limits: Many[Limits], poses: Iterable[Pose] = (), seconds: float = SLOWLY
) -> tuple[Step, ...]:
    """Return what leads slowly to `stand`: that of `poses`, or else the authors'."""
    stand = next((pose for pose in poses if pose.name == STAND.name), STAND)
    return (Step(cropped(stand, limits), seconds, stand.name),)


def _stages(played: Sequence | Gait, poses: Iterable[Pose]) -> list[tuple[Pose, float]]:
    if isinstance(played, Gait):
        return [(stage.pose, stage.seconds) for stage in played.stages]
    known = {pose.name: pose for pose in poses}
    if missing := missing_poses(played, known.values()):
        names = ", ".join(missing)
        raise BadRequest(f"{played.name} names poses that are not defined: {names}")
    if not played.steps:
        raise BadRequest(f"{played.name} has no steps")
    return [(known[step.pose_name], step.milliseconds / 1000) for step in played.steps]
