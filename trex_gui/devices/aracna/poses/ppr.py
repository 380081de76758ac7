"""`.ppr` files: poses and sequences as the editor PyPose keeps them, one item a line.

    Name:count:resolution:resolution...
    Pose=name:512, 512, ...
    Seq=name: pose|500, pose|500, ...
    Nuke=...

Ref: CreativeMachinesLab/aracna `RaspberryPypose/project.py`. There the last of two items of one
name wins, missing positions are 512, wrong resolutions are 1024, and a line without prefix is a
pose of an older version. `Nuke` belongs to code for legged robots that PyPose made; it is kept.

Blanks around a name do not count, for those around the names in steps never did: PyPose takes them
away there, and finds no pose whose name has some.

A line that cannot be understood is kept as it stands, and written back.
"""

import re
from collections.abc import Callable, Iterable
from typing import TypeVar

from trex_gui.core.files.errors import Finding, Severity
from trex_gui.devices.aracna.poses.naming import free_number
from trex_gui.devices.aracna.poses.pose import CENTRE, Pose
from trex_gui.devices.aracna.poses.project import MOST_MOTORS, RESOLUTION, Project, missing_from
from trex_gui.devices.aracna.poses.sequence import LONGEST_MS, SHORTEST_MS, Sequence, SequenceStep
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS

SUFFIX = ".ppr"

_NUMBER = re.compile(r"[0-9]{1,9}")
_POSE, _SEQUENCE, _NUKE = "Pose=", "Seq=", "Nuke="

ItemT = TypeVar("ItemT", Pose, Sequence)
_Placed = tuple[int, ItemT]


class _UnreadableError(ValueError):
    """A line that is kept as it stands; says why."""


def read_ppr(text: str) -> tuple[Project, tuple[Finding, ...]]:
    """Return what a pose file holds, and what a person should know of it, line by line.

    Every text gives a project. A finding that is an error stands for a line that is not used;
    of a warning, something was taken for granted.
    """
    parting = "\r" if "\r" in text and "\n" not in text else "\n"  # "\r": of an old Macintosh
    lines = text.split(parting)
    line_end = "\r\n" if lines[0].endswith("\r") else parting
    if lines[-1] == "":
        lines.pop()
    lines = [line.removesuffix("\r") for line in lines]
    reader = _Reader()
    if not lines or lines[0].startswith((_POSE, _SEQUENCE, _NUKE)):
        said = "the first line names the robot and its servos; 8 servos are taken for granted"
        reader.warn(1, said)
        name, resolutions, body = "", (RESOLUTION,) * MOTORS, 1
    else:
        name, resolutions = reader.head(lines.pop(0))
        body = 2
    for number, line in enumerate(lines, body):
        reader.take(number, line, len(resolutions))
    poses = reader.unique(reader.poses, _named_pose, "pose")
    sequences = reader.unique(reader.sequences, _named_sequence, "sequence")
    known = {pose.name for pose in poses}
    for number, sequence in reader.sequences:
        for missing in missing_from(sequence, known):
            said = f"sequence {sequence.name} names the pose {missing}, which is not in the file"
            reader.warn(number, said)
    findings = tuple(sorted(reader.findings, key=lambda finding: finding.line or 0))
    return Project(name, resolutions, poses, sequences, tuple(reader.rest), line_end), findings


def write_ppr(project: Project) -> str:
    """Return the text of a pose file, as PyPose would write it.

    A pose of fewer motors than the robot has gets the positions that reading it would give it.
    """
    head = [project.name, str(project.motors), *map(str, project.resolutions)]
    lines = [":".join(head)]
    for pose in project.poses:
        positions = pose.first(max(project.motors, len(pose.positions)))
        lines.append(f"{_POSE}{pose.name}:{_listed(positions)}")
    for sequence in project.sequences:
        steps = (f"{step.pose_name}|{step.milliseconds}" for step in sequence.steps)
        lines.append(f"{_SEQUENCE}{sequence.name}: {_listed(steps)}")
    return "".join(line + project.line_end for line in [*lines, *project.rest])


def _listed(values: Iterable[object]) -> str:
    return ", ".join(map(str, values))


class _Reader:
    """Takes the lines of one file."""

    def __init__(self) -> None:
        self.poses: list[tuple[int, Pose]] = []
        self.sequences: list[tuple[int, Sequence]] = []
        self.rest: list[str] = []
        self.padded: set[int] = set()  # lines whose name has blanks around it
        self.findings: list[Finding] = []

    def warn(self, line: int, message: str) -> None:
        self.findings.append(Finding(line, None, message, Severity.WARNING))

    def head(self, line: str) -> tuple[str, tuple[int, ...]]:
        """Return name and resolutions of the first line."""
        name, *numbers = line.split(":")
        count = _number(numbers[0]) if numbers else None
        if count is None or not 1 <= count <= MOST_MOTORS:
            given = f", not {numbers[0].strip()!r}" if numbers else ""
            said = f"how many servos there are is a number from 1 to {MOST_MOTORS}{given}"
            self.warn(1, f"{said}; {MOTORS} are taken for granted")
            return name, (RESOLUTION,) * MOTORS
        given_ones = [_number(number) for number in numbers[1:]]
        resolutions = tuple(one for one in given_ones if one)
        if len(given_ones) != count or len(resolutions) != count:
            said = f"{count} resolutions are expected and {len(resolutions)} found"
            self.warn(1, f"{said}; {RESOLUTION} is taken for every servo")
            resolutions = (RESOLUTION,) * count
        return name, resolutions

    def take(self, number: int, line: str, motors: int) -> None:
        """Take one line below the first."""
        try:
            if line.startswith(_SEQUENCE):
                self.sequences.append((number, _sequence(line.removeprefix(_SEQUENCE))))
                self._look_for_blanks(number, line.removeprefix(_SEQUENCE))
                return
            if line.startswith(_NUKE):
                self.rest.append(line)
                return
            pose = _pose(line.removeprefix(_POSE))
        except ValueError as error:
            self.rest.append(line)
            if line.strip():
                message = f"{error}; the line is kept, but not used"
                self.findings.append(Finding(number, None, message))
            return
        if len(pose.positions) < motors:
            said = f"pose {pose.name} has {len(pose.positions)} positions of {motors}"
            self.warn(number, f"{said}; those that are missing become {CENTRE}")
            pose = Pose(pose.name, pose.first(motors))
        elif len(pose.positions) > motors:
            said = f"pose {pose.name} has {len(pose.positions)} positions for {motors} servos"
            self.warn(number, f"{said}; the last ones are kept, but not used")
        self.poses.append((number, pose))
        self._look_for_blanks(number, line.removeprefix(_POSE))

    def _look_for_blanks(self, number: int, line: str) -> None:
        name = line.partition(":")[0]
        if name != name.strip():
            self.padded.add(number)

    def unique(
        self, items: list[tuple[int, ItemT]], named: Callable[[ItemT, str], ItemT], kind: str
    ) -> tuple[ItemT, ...]:
        """Return items with a name each; the last of a name has it, others get another.

        One that is spelled as the name is goes before one with blanks around it: it is the one
        that steps have meant.
        """
        taken = {item.name for _, item in items}
        spelled = sorted(items, key=lambda placed: (placed[0] not in self.padded, placed[0]))
        last = {item.name: number for number, item in spelled}
        tried: dict[str, int] = {}
        for place, (number, item) in enumerate(items):
            if last[item.name] != number:
                name, tried[item.name] = free_number(item.name, taken, tried.get(item.name, 2))
                taken.add(name)
                said = f"the {kind} {item.name} comes again in line {last[item.name]}"
                if {number, last[item.name]} & self.padded:
                    said = f"but for blanks around its name, {said}"
                self.warn(number, f"{said}, which counts; this one is called {name} now")
                items[place] = (number, named(item, name))
        return tuple(item for _, item in items)


def _named_pose(pose: Pose, name: str) -> Pose:
    return Pose(name, pose.positions)


def _named_sequence(sequence: Sequence, name: str) -> Sequence:
    return Sequence(name, sequence.steps)


def _pose(line: str) -> Pose:
    name, colon, values = line.partition(":")
    name = name.strip()
    if not colon:
        raise _UnreadableError("neither a pose nor a sequence, for it has no colon")
    if not name:
        raise _UnreadableError("a pose has a name before its colon")
    positions = []
    for motor, field in enumerate(_fields(values)):
        position = _number(field)
        if position is None or position > HIGHEST:
            said = f"pose {name}: positions are numbers from 0 to {HIGHEST}"
            raise _UnreadableError(f"{said}, not {field.strip()!r} (motor {motor})")
        positions.append(position)
    return Pose(name, tuple(positions))


def _sequence(line: str) -> Sequence:
    name, colon, values = line.partition(":")
    name = name.strip()
    if not colon:
        raise _UnreadableError("a sequence has a colon after its name")
    if not name:
        raise _UnreadableError("a sequence has a name before its colon")
    steps = []
    for field in _fields(values):
        pose_name, bar, time = field.strip().partition("|")
        milliseconds = _number(time)
        if not bar or milliseconds is None or not SHORTEST_MS <= milliseconds <= LONGEST_MS:
            said = f"sequence {name}: a step is a pose, a bar and {SHORTEST_MS} to {LONGEST_MS} ms"
            raise _UnreadableError(f"{said}, not {field.strip()!r}")
        steps.append(SequenceStep(pose_name.strip(), milliseconds))
    return Sequence(name, tuple(steps))


def _fields(values: str) -> list[str]:
    """Take values apart; a comma after the last one is let pass."""
    fields = values.split(",")
    if not fields[-1].strip():
        fields.pop()
    return fields


def _number(field: str) -> int | None:
    found = field.strip(" \t")
    return int(found) if _NUMBER.fullmatch(found) else None
