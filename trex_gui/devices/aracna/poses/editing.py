"""Edits of a project, each giving another one.

All of them raise `BadRequest` where they name an item that is not there, or where what they are
given is none: a name that is taken, a position outside 0-1023.
"""

from collections.abc import Sequence as Many
from dataclasses import replace
from typing import TypeVar

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.poses.gaits import Gait
from trex_gui.devices.aracna.poses.naming import checked_name, free_name
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.project import Project
from trex_gui.devices.aracna.poses.sequence import SHORTEST_MS, Sequence, SequenceStep

ItemT = TypeVar("ItemT", Pose, Sequence)


def named_pose(name: str, positions: Many[int]) -> Pose:
    """Return a pose, or say why there is none."""
    try:
        return Pose(name, tuple(positions))
    except ValueError as error:
        raise BadRequest(str(error)) from None


def with_pose(project: Project, name: str, positions: Many[int]) -> Project:
    """Add a pose at the end."""
    name = checked_name(name, [pose.name for pose in project.poses])
    return replace(project, poses=(*project.poses, named_pose(name, positions)))


def with_positions(project: Project, name: str, positions: Many[int]) -> Project:
    """Move a pose."""
    place = _index(project.poses, name)
    moved = named_pose(project.poses[place].name, positions)
    return replace(project, poses=_put(project.poses, place, moved))


def with_pose_renamed(project: Project, name: str, new_name: str) -> Project:
    """Give a pose another name, which the steps that name it follow."""
    place = _index(project.poses, name)
    new_name = checked_name(new_name, [pose.name for pose in project.poses if pose.name != name])
    sequences = tuple(
        replace(
            sequence,
            steps=tuple(
                replace(step, pose_name=new_name) if step.pose_name == name else step
                for step in sequence.steps
            ),
        )
        for sequence in project.sequences
    )
    renamed = replace(project.poses[place], name=new_name)
    return replace(project, poses=_put(project.poses, place, renamed), sequences=sequences)


def with_pose_copied(project: Project, name: str) -> tuple[Project, str]:
    """Put a copy of a pose behind it; return its name too."""
    poses, copied = _with_copy(project.poses, name)
    return replace(project, poses=poses), copied


def without_pose(project: Project, name: str) -> Project:
    """Take a pose away; the steps that name it stay."""
    return replace(project, poses=_without(project.poses, name))


def with_pose_moved(project: Project, name: str, place: int) -> Project:
    """Put a pose at a place in the order, from 0; one beyond the end is the end."""
    return replace(project, poses=_moved(project.poses, name, place))


def with_sequence(project: Project, name: str, steps: Many[SequenceStep]) -> Project:
    """Add a sequence at the end."""
    name = checked_name(name, [sequence.name for sequence in project.sequences])
    return replace(project, sequences=(*project.sequences, Sequence(name, tuple(steps))))


def with_steps(project: Project, name: str, steps: Many[SequenceStep]) -> Project:
    """Give a sequence other steps."""
    place = _index(project.sequences, name)
    return replace(project, sequences=_put(project.sequences, place, Sequence(name, tuple(steps))))


def with_sequence_renamed(project: Project, name: str, new_name: str) -> Project:
    """Give a sequence another name."""
    place = _index(project.sequences, name)
    others = [sequence.name for sequence in project.sequences if sequence.name != name]
    renamed = replace(project.sequences[place], name=checked_name(new_name, others))
    return replace(project, sequences=_put(project.sequences, place, renamed))


def with_sequence_copied(project: Project, name: str) -> tuple[Project, str]:
    """Put a copy of a sequence behind it; return its name too."""
    sequences, copied = _with_copy(project.sequences, name)
    return replace(project, sequences=sequences), copied


def without_sequence(project: Project, name: str) -> Project:
    """Take a sequence away."""
    return replace(project, sequences=_without(project.sequences, name))


def with_sequence_moved(project: Project, name: str, place: int) -> Project:
    """Put a sequence at a place in the order, from 0; one beyond the end is the end."""
    return replace(project, sequences=_moved(project.sequences, name, place))


def with_gait(project: Project, gait: Gait) -> tuple[Project, str]:
    """Add a gait as a sequence, and the poses of it that are not there; return its name.

    A pose that is there under the same name with other positions is left alone, and the gait's
    own is added under another name.
    """
    poses, steps = list(project.poses), []
    for stage in gait.stages:
        known = Pose(stage.pose.name, stage.pose.positions)
        if known not in project.poses:
            known = replace(known, name=f"{gait.name} {stage.pose.name}")
        if known not in poses:
            known = replace(known, name=free_name(known.name, [pose.name for pose in poses]))
            poses.append(known)
        steps.append(SequenceStep(known.name, max(round(stage.seconds * 1000), SHORTEST_MS)))
    name = free_name(gait.name, [sequence.name for sequence in project.sequences])
    sequences = (*project.sequences, Sequence(name, tuple(steps)))
    return replace(project, poses=tuple(poses), sequences=sequences), name


def _index(items: tuple[ItemT, ...], name: str) -> int:
    for place, item in enumerate(items):
        if item.name == name:
            return place
    raise BadRequest(f"there is nothing called {name}")


def _put(items: tuple[ItemT, ...], place: int, item: ItemT) -> tuple[ItemT, ...]:
    return items[:place] + (item,) + items[place + 1 :]  # noqa: RUF005 - keeps the type


def _without(items: tuple[ItemT, ...], name: str) -> tuple[ItemT, ...]:
    place = _index(items, name)
    return items[:place] + items[place + 1 :]


def _moved(items: tuple[ItemT, ...], name: str, place: int) -> tuple[ItemT, ...]:
    item = items[_index(items, name)]
    others = _without(items, name)
    place = min(max(place, 0), len(others))
    return others[:place] + (item,) + others[place:]  # noqa: RUF005 - keeps the type


def _with_copy(items: tuple[ItemT, ...], name: str) -> tuple[tuple[ItemT, ...], str]:
    place = _index(items, name)
    copied = free_name(name, [item.name for item in items])
    copy = replace(items[place], name=copied)
    behind = place + 1
    return items[:behind] + (copy,) + items[behind:], copied  # noqa: RUF005 - keeps the type
