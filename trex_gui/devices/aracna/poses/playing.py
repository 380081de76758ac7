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
    sequence: Sequence, poses: Iterable[Pose], limits: Many[Limits], time_scale: float = 1.0
) -> tuple[Step, ...]:
    """Return the steps of a sequence or gait, clamped to each motor's limits.

    Raises BadRequest if it has no steps, or if a pose is not defined.
    """
    return tuple(
        Step(clamped(pose, limits), seconds * time_scale, pose.name)
        for pose, seconds in stages_of(sequence, poses)
    )


def motor_count_warning(poses: Iterable[Pose], motors: int) -> str:
    """Return a warning if poses are for another number of motors, otherwise an empty text."""
    counts = {len(pose.positions) for pose in poses} - {motors}
    if not counts:
        return ""
    text = tr(
        "The poses are for {0} motors, but the robot has {1}: the last positions are ignored."
    )
    if max(counts) < motors:
        text = tr(
            "The poses are for {0} motors, but the robot has {1}: the remaining motors go to {2}."
        )
    return text.format(max(counts), motors, CENTER)


def clamped(pose: Pose, limits: Many[Limits]) -> tuple[int, ...]:
    return clamp(pose.for_motors(len(limits)), limits)


def blend_in(
    sequence: Sequence, poses: Iterable[Pose], limits: Many[Limits], present: Present = ()
) -> tuple[Step, ...]:
    """Return the slow step to the start, or no step if none is necessary.

    A cyclic gait starts in its last pose, and a sequence in its first pose. Raises BadRequest like
    `steps_of`.
    """
    index = 0
    if isinstance(sequence, Gait):
        if not sequence.cyclic:
            return ()
        index = -1
    start, _ = stages_of(sequence, poses)[index]
    goals = clamped(start, limits)
    return () if tuple(present) == goals else (Step(goals, SLOW_SECONDS, start.name),)


def blend_out(limits: Many[Limits], poses: Iterable[Pose] = ()) -> tuple[Step, ...]:
    """Return the slow step to the pose `stand` in `poses`, or to the built-in pose."""
    stand = next((pose for pose in poses if pose.name == STAND.name), STAND)
    return (Step(clamped(stand, limits), SLOW_SECONDS, stand.name),)


def slow_motors(
    steps: Many[Step], start: Present = (), *, repeated: bool = False
) -> dict[int, dict[int, float]]:
    """Return the time that motors need if a step is too short: step index → motor → seconds.

    A motor at an unknown position does not count as slow. `repeated`: True if the steps repeat.
    """
    slow = [_slow_in(step, before) for before, step in _with_starts(steps, start)]
    if repeated:
        for motor, needed in _slow_in(steps[0], steps[-1].goals).items():
            slow[0][motor] = max(needed, slow[0].get(motor, 0.0))
    return {number: motors for number, motors in enumerate(slow) if motors}


def estimated_seconds(steps: Many[Step], start: Present = ()) -> float:
    return sum(
        max(step.seconds, COMMAND_SECONDS, *_slow_in(step, before).values())
        for before, step in _with_starts(steps, start)
    )


def _with_starts(steps: Many[Step], start: Present) -> Iterable[tuple[Present, Step]]:
    return zip((start, *(step.goals for step in steps)), steps, strict=False)


def _slow_in(step: Step, before: Present) -> dict[int, float]:
    slow = {}
    for motor, (start, goal) in enumerate(zip(before, step.goals, strict=False)):
        needed = 0.0 if start is None else travel_seconds(goal - start, 0)
        if needed > step.seconds:
            slow[motor] = needed
    return slow


def stages_of(sequence: Sequence, poses: Iterable[Pose]) -> list[tuple[Pose, float]]:
    """Return each step's pose and seconds. Raises BadRequest like `steps_of`."""
    known = {pose.name: pose for pose in (sequence.poses if isinstance(sequence, Gait) else poses)}
    if missing := sequence.missing_poses(known):
        raise BadRequest(
            tr("{0} uses poses that are not defined: {1}").format(sequence.name, ", ".join(missing))
        )
    if not sequence.steps:
        raise BadRequest(tr("{0} has no steps").format(sequence.name))
    return [(known[step.pose_name], step.milliseconds / 1000) for step in sequence.steps]
