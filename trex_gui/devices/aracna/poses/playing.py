"""Goals and durations of the steps of a sequence or gait."""

from collections.abc import Iterable
from collections.abc import Sequence as Many

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.poses.gaits import SLOW_SECONDS, STAND, Gait
from trex_gui.devices.aracna.poses.project import Pose, Sequence
from trex_gui.devices.aracna.protocol.joints import CENTER, Limits, clamp, travel_seconds
from trex_gui.devices.aracna.session.messages import Step

Present = Many[int | None]  # position of each motor; `None`: unknown
COMMAND_SECONDS = 0.1  # shortest step; without motion, `.v` takes 42-55 ms and `.c` 33-37 ms


def steps_of(
    played: Sequence, poses: Iterable[Pose], limits: Many[Limits], time_scale: float = 1.0
) -> tuple[Step, ...]:
    """Return the steps of a sequence or gait, clamped to each motor's limits.

    Raises BadRequest if it has no steps, or if a pose is not defined.
    """
    return tuple(
        Step(clamped(pose, limits), seconds * time_scale, pose.name)
        for pose, seconds in stages_of(played, poses)
    )


def mismatch(poses: Iterable[Pose], motors: int) -> str:
    """Return a warning if poses are for another number of motors, otherwise an empty text."""
    counts = {len(pose.positions) for pose in poses} - {motors}
    if not counts:
        return ""
    text = tr(
        "The poses are for {0} motors, but the robot has {1}: the last positions are ignored."
    )
    if max(counts) < motors:
        text = tr("The poses are for {0} motors, but the robot has {1}: its last motors go to {2}.")
    return text.format(max(counts), motors, CENTER)


def clamped(pose: Pose, limits: Many[Limits]) -> tuple[int, ...]:
    return clamp(pose.for_motors(len(limits)), limits)


def blend_in(
    played: Sequence, poses: Iterable[Pose], limits: Many[Limits], present: Present = ()
) -> tuple[Step, ...]:
    """Return the slow step to the start. Empty if it is not necessary.

    A cyclic gait starts in its last pose, and a sequence in its first pose. Raises BadRequest like
    `steps_of`.
    """
    index = 0
    if isinstance(played, Gait):
        if not played.cyclic:
            return ()
        index = -1
    start, _ = stages_of(played, poses)[index]
    goals = clamped(start, limits)
    return () if tuple(present) == goals else (Step(goals, SLOW_SECONDS, start.name),)


def blend_out(limits: Many[Limits], poses: Iterable[Pose] = ()) -> tuple[Step, ...]:
    """Return the slow step to the pose `stand`. The default is the built-in pose."""
    stand = next((pose for pose in poses if pose.name == STAND.name), STAND)
    return (Step(clamped(stand, limits), SLOW_SECONDS, stand.name),)


def late_motors(
    steps: Many[Step], start: Present = (), *, again: bool = False
) -> dict[int, dict[int, float]]:
    """Return the time that slow motors need: step index → motor → seconds.

    A motor at an unknown position does not count as slow. `again`: the steps repeat.
    """
    late = [_late_in(step, before) for before, step in _with_starts(steps, start)]
    if again:
        late[0] |= _late_in(steps[0], steps[-1].goals)
    return {number: motors for number, motors in enumerate(late) if motors}


def estimated_seconds(steps: Many[Step], start: Present = ()) -> float:
    return sum(
        max(step.seconds, COMMAND_SECONDS, *_late_in(step, before).values())
        for before, step in _with_starts(steps, start)
    )


def _with_starts(steps: Many[Step], start: Present) -> Iterable[tuple[Present, Step]]:
    return zip((start, *(step.goals for step in steps)), steps, strict=False)


def _late_in(step: Step, before: Present) -> dict[int, float]:
    late = {}
    for motor, (start, goal) in enumerate(zip(before, step.goals, strict=False)):
        needed = 0.0 if start is None else travel_seconds(goal - start, 0)
        if needed > step.seconds:
            late[motor] = needed
    return late


def stages_of(played: Sequence, poses: Iterable[Pose]) -> list[tuple[Pose, float]]:
    known = {pose.name: pose for pose in (played.poses if isinstance(played, Gait) else poses)}
    if missing := played.missing_poses(known):
        raise BadRequest(
            tr("{0} uses poses that are not defined: {1}").format(played.name, ", ".join(missing))
        )
    if not played.steps:
        raise BadRequest(tr("{0} has no steps").format(played.name))
    return [(known[step.pose_name], step.milliseconds / 1000) for step in played.steps]
