"""Pose files of the command line: which pose or sequence is meant, and what is cut to limits."""

from collections.abc import Sequence as Many
from pathlib import Path

from trex_gui.core.cli.console import CommandFailed, UsageError, refusals, say
from trex_gui.devices.aracna.poses.named_poses import KNOWN_POSES
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.project import Project
from trex_gui.devices.aracna.poses.sequence import Sequence
from trex_gui.devices.aracna.protocol.joints import Limits, factory_limits


def read_project(file: str) -> Project:
    """Return what a pose file holds; what is to know of it is said.

    Raises:
        Refused: it cannot be read.
    """
    from trex_gui.devices.aracna.model.pose_file import read_file  # noqa: PLC0415 - loads YAML

    with refusals():
        read = read_file(Path(file))
    for finding in read.findings:
        say(f"{file}: {finding}")
    return read.project


def pose_named(name: str, file: str | None) -> Pose:
    """Return a pose of a file, or one that the robot's authors used.

    Raises:
        Usage: there is none of that name.
        Refused: the file cannot be read.
    """
    poses = KNOWN_POSES if file is None else read_project(file).poses
    for pose in poses:
        if pose.name == name:
            return pose
    known = ", ".join(pose.name for pose in poses) or "none"
    raise UsageError(f"There is no pose {name!r}. Known are: {known}.")


def sequence_named(project: Project, name: str | None) -> Sequence:
    """Return the sequence that is meant; the only one needs no name.

    Raises:
        Usage: there is none of that name, or several and none was named.
        Refused: the file has no sequence.
    """
    names = ", ".join(one.name for one in project.sequences)
    if not project.sequences:
        raise CommandFailed("The file has no sequence.")
    if name is None:
        if len(project.sequences) > 1:
            raise UsageError(f"Which sequence? Give --sequence. The file has: {names}.")
        return project.sequences[0]
    if (found := project.sequence(name)) is None:
        raise UsageError(f"There is no sequence {name!r}. The file has: {names}.")
    return found


def limits_of(motors: int, *, lifted: bool) -> tuple[Limits, ...]:
    """Return how far each joint may turn."""
    return (Limits(),) * motors if lifted else factory_limits(motors)


def cut(pose: Pose, limits: Many[Limits]) -> tuple[int, ...]:
    """Return where a pose sends each motor within its limits; what is cut is said."""
    wanted = pose.first(len(limits))
    goals = tuple(limit.crop(place) for limit, place in zip(limits, wanted, strict=True))
    for motor, (want, goal) in enumerate(zip(wanted, goals, strict=True)):
        if want != goal:
            say(f"{pose.name}: motor {motor} is sent to {goal}, its limit, not to {want}.")
    return goals
