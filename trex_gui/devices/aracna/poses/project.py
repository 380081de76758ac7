"""Poses, sequences and names in a pose file."""

from collections.abc import Collection, Iterable
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.protocol.joints import CENTER, HIGHEST, MOTORS

SHORTEST_MS = 1  # minimum duration of a step
LONGEST_MS = 3_600_000  # an hour; PyPose itself offers up to 5000 ms
DEFAULT_MS = 500  # PyPose's default for a step
RESOLUTION = 1024  # number of positions of a servo
MAX_MOTORS = 254  # servos that a bus can address (AX-12: identifiers 0-253)
_MAX_NAME_LENGTH = 100
_SEPARATORS = ":,|"  # between names and values in a pose file


@dataclass(frozen=True, slots=True)
class Pose:
    """Named positions (0-1023), motor 0 first. Raises BadRequest for an invalid value."""

    name: str
    positions: tuple[int, ...]

    def __post_init__(self) -> None:
        if not _is_valid_name(self.name) or not all(
            0 <= value <= HIGHEST for value in self.positions
        ):
            raise BadRequest(f"invalid pose: {self!r}")

    def for_motors(self, motors: int) -> tuple[int, ...]:
        """Return the positions of `motors` motors. Missing positions become the centre."""
        missing = max(motors - len(self.positions), 0)
        return self.positions[:motors] + (CENTER,) * missing


@dataclass(frozen=True, slots=True)
class SequenceStep:
    """Name of a pose, and the time to reach it. Raises BadRequest for an invalid value."""

    pose_name: str
    milliseconds: int = DEFAULT_MS

    def __post_init__(self) -> None:
        has_time = SHORTEST_MS <= self.milliseconds <= LONGEST_MS
        if not is_usable_in_step(self.pose_name) or not has_time:
            raise BadRequest(f"invalid step: {self!r}")


@dataclass(frozen=True, slots=True)
class Sequence:
    """Named steps. Raises BadRequest for a colon or line end in the name."""

    name: str
    steps: tuple[SequenceStep, ...] = ()

    def __post_init__(self) -> None:
        if not _is_valid_name(self.name):
            raise BadRequest(f"invalid sequence: {self!r}")

    def missing_poses(self, known: Collection[str]) -> tuple[str, ...]:
        used = dict.fromkeys(step.pose_name for step in self.steps)
        return tuple(name for name in used if name not in known)


@dataclass(frozen=True, slots=True)
class Project:
    """Poses and sequences of a robot, in the order of the file.

    Names are unique. Sequences may name poses that are not defined.
    """

    name: str = "Aracna"
    resolutions: tuple[int, ...] = (RESOLUTION,) * MOTORS  # number of positions of each servo
    poses: tuple[Pose, ...] = ()
    sequences: tuple[Sequence, ...] = ()
    rest: tuple[str, ...] = ()  # other lines, written at the end of the file
    line_end: str = "\n"

    @property
    def motors(self) -> int:
        return len(self.resolutions)

    @property
    def pose_names(self) -> tuple[str, ...]:
        return tuple(pose.name for pose in self.poses)

    def pose(self, name: str) -> Pose | None:
        return next((pose for pose in self.poses if pose.name == name), None)

    def sequence(self, name: str) -> Sequence | None:
        return next((sequence for sequence in self.sequences if sequence.name == name), None)


def is_usable_in_step(pose_name: str) -> bool:
    """Return True if a step can use this pose. A comma or a bar would end its name."""
    return not any(sign in pose_name for sign in ",|\r\n")


def _is_valid_name(name: str) -> bool:
    return not any(sign in name for sign in ":\r\n")


def free_name(name: str, taken: Iterable[str]) -> str:
    names = set(taken)
    return numbered_name(name, names)[0] if name in names else name


def numbered_name(name: str, taken: AbstractSet[str], first: int = 2) -> tuple[str, int]:
    """Append the first free number to a name. Also return the number after it."""
    number = first
    while f"{name} {number}" in taken:
        number += 1
    return f"{name} {number}", number + 1


def checked_name(name: str, taken: Iterable[str]) -> str:
    """Strip a name. Raises BadRequest if it is taken or invalid."""
    stripped = name.strip()
    is_valid = stripped.isprintable() and not any(sign in _SEPARATORS for sign in stripped)
    if not is_valid or not 0 < len(stripped) <= _MAX_NAME_LENGTH:
        text = tr("a name must have 1 to {0} printable characters, without colon, comma or bar")
        raise BadRequest(text.format(_MAX_NAME_LENGTH))
    if stripped in set(taken):
        raise BadRequest(tr("the name {0} is taken").format(stripped))
    return stripped
