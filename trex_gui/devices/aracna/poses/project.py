"""What one pose file holds."""

from collections.abc import Iterable
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.sequence import Sequence
from trex_gui.devices.aracna.protocol.units import MOTORS

RESOLUTION = 1024
"""Positions that a servo knows."""

MOST_MOTORS = 253
"""Servos that a bus can name (identifiers 0-252); a file with more is none of poses."""


@dataclass(frozen=True, slots=True)
class Project:
    """Poses and sequences of one robot.

    Attributes:
        name: of the robot.
        resolutions: positions that each servo knows; their number is that of the motors.
        poses: in the order of the file; each name once.
        sequences: in the order of the file; each name once. They may name poses that are not here.
        rest: lines that are neither, as they stand; they are written back at the end.
        line_end: as the file has it.
    """

    name: str = "Aracna"
    resolutions: tuple[int, ...] = (RESOLUTION,) * MOTORS
    poses: tuple[Pose, ...] = ()
    sequences: tuple[Sequence, ...] = ()
    rest: tuple[str, ...] = ()
    line_end: str = "\n"

    @property
    def motors(self) -> int:
        """How many motors the robot has."""
        return len(self.resolutions)

    def pose(self, name: str) -> Pose | None:
        """Return the pose of a name."""
        return next((pose for pose in self.poses if pose.name == name), None)

    def sequence(self, name: str) -> Sequence | None:
        """Return the sequence of a name."""
        return next((one for one in self.sequences if one.name == name), None)


def missing_poses(sequence: Sequence, poses: Iterable[Pose]) -> tuple[str, ...]:
    """Return the names that a sequence uses and nobody has defined, each once, in its order."""
    return missing_from(sequence, {pose.name for pose in poses})


def missing_from(sequence: Sequence, known: AbstractSet[str]) -> tuple[str, ...]:
    """Return the names that a sequence uses and that are not known, each once, in its order."""
    named = dict.fromkeys(step.pose_name for step in sequence.steps)
    return tuple(name for name in named if name not in known)
