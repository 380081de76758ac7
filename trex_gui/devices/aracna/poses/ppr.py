"""`.ppr` files of the editor PyPose: poses and sequences, one per line.

    Name:count:resolution:resolution...
    Pose=name:512, 512, ...
    Seq=name: pose|500, pose|500, ...
    Nuke=...

Ref: CreativeMachinesLab/aracna `RaspberryPypose/project.py`. In PyPose, the last of two items with
the same name wins, missing positions become 512, wrong resolutions become 1024, and a line without
a prefix is a pose from an older version. PyPose strips the names in steps, so it does not find a
pose with blanks around its name. This module ignores blanks around a name.

`Nuke` lines are for code that PyPose generated for legged robots. These lines and unreadable lines
after the first are written back unchanged.
"""

import re
from codecs import BOM_UTF8
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

from trex_gui.core.files import Finding, SettingsError, Severity, load
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.poses.project import (
    LONGEST_MS,
    MAX_MOTORS,
    RESOLUTION,
    SHORTEST_MS,
    Pose,
    Project,
    Sequence,
    SequenceStep,
    numbered_name,
)
from trex_gui.devices.aracna.protocol.joints import CENTER, HIGHEST, MOTORS

SUFFIX = ".ppr"

_NUMBER = re.compile(r"[0-9]{1,9}")
_POSE, _SEQUENCE, _NUKE = "Pose=", "Seq=", "Nuke="

ItemT = TypeVar("ItemT", Pose, Sequence)


@dataclass(frozen=True, slots=True)
class PoseFile:
    project: Project
    findings: tuple[Finding, ...]
    data: bytes


def read_file(path: Path) -> PoseFile:
    """Read a pose file. Raises SettingsError if it is unreadable, too large or binary."""
    data = load(path, tr("poses"))
    encoding_findings: list[Finding] = []
    content = data.removeprefix(BOM_UTF8)
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        text = content.decode("latin-1")
        message = tr(
            "this text is not in UTF-8; it was read as Western European, and will be saved as UTF-8"
        )
        encoding_findings.append(Finding(line, None, message, Severity.WARNING))
    for number, line_text in enumerate(text.split("\n"), 1):
        if any(sign < " " and sign not in "\n\t\r" for sign in line_text):
            message = tr("this is a binary file, but pose files contain text")
            raise SettingsError(str(path), [Finding(number, None, message)])
    project, findings = read_ppr(text)
    return PoseFile(project, (*encoding_findings, *findings), data)


def read_ppr(text: str) -> tuple[Project, tuple[Finding, ...]]:
    """Return the project in a text, with findings. Never rejects a text.

    A finding is an error if its line is not used, and a warning if something was assumed.
    """
    separator = "\r" if "\r" in text and "\n" not in text else "\n"  # old Macintosh files use "\r"
    lines = text.split(separator)
    line_end = "\r\n" if lines[0].endswith("\r") else separator
    if lines[-1] == "":
        lines.pop()
    lines = [line.removesuffix("\r") for line in lines]
    reader = _Reader()
    if not lines or lines[0].startswith((_POSE, _SEQUENCE, _NUKE)):
        reader.warn(1, _no_header())
        name, resolutions, body = "", (RESOLUTION,) * MOTORS, 1
    else:
        name, resolutions = reader.header(lines.pop(0))
        body = 2
    for number, line in enumerate(lines, body):
        reader.read_line(number, line, len(resolutions))
    poses = reader.with_unique_names(reader.poses, "pose")
    sequences = reader.with_unique_names(reader.sequences, "sequence")
    known = {pose.name for pose in poses}
    for number, sequence in reader.sequences:
        for missing in sequence.missing_poses(known):
            message = tr("sequence {0} uses the pose {1}, which is not in the file").format(
                sequence.name, missing
            )
            reader.warn(number, message)
    findings = tuple(sorted(reader.findings, key=lambda finding: finding.line or 0))
    return Project(name, resolutions, poses, sequences, tuple(reader.rest), line_end), findings


def write_ppr(project: Project) -> str:
    """Return a project in PyPose's format. Missing positions become the centre."""
    lines = [":".join([project.name, str(project.motors), *map(str, project.resolutions)])]
    for pose in project.poses:
        positions = pose.for_motors(max(project.motors, len(pose.positions)))
        lines.append(f"{_POSE}{pose.name}:{_joined(positions)}")
    for sequence in project.sequences:
        steps = (f"{step.pose_name}|{step.milliseconds}" for step in sequence.steps)
        lines.append(f"{_SEQUENCE}{sequence.name}: {_joined(steps)}")
    return "".join(line + project.line_end for line in [*lines, *project.rest])


def _joined(values: Iterable[object]) -> str:
    return ", ".join(map(str, values))


class _Reader:
    def __init__(self) -> None:
        self.poses: list[tuple[int, Pose]] = []
        self.sequences: list[tuple[int, Sequence]] = []
        self.rest: list[str] = []
        self.findings: list[Finding] = []
        self._with_blanks: set[int] = set()  # numbers of lines with blanks around the name

    def warn(self, line: int, message: str) -> None:
        self.findings.append(Finding(line, None, message, Severity.WARNING))

    def header(self, line: str) -> tuple[str, tuple[int, ...]]:
        name, *numbers = line.split(":")
        count = _number(numbers[0]) if numbers else None
        if count is None or not 1 <= count <= MAX_MOTORS:
            self.warn(1, _no_header())
            return name, (RESOLUTION,) * MOTORS
        resolutions = tuple(number for number in map(_number, numbers[1:]) if number)
        if not len(numbers) - 1 == len(resolutions) == count:
            text = tr("{0} resolutions are expected; assuming {1} for every servo")
            self.warn(1, text.format(count, RESOLUTION))
            resolutions = (RESOLUTION,) * count
        return name, resolutions

    def read_line(self, number: int, line: str, motors: int) -> None:
        name = line.removeprefix(_SEQUENCE).removeprefix(_POSE).partition(":")[0]
        if name != name.strip():
            self._with_blanks.add(number)
        try:
            if line.startswith(_SEQUENCE):
                self.sequences.append((number, _sequence(line.removeprefix(_SEQUENCE))))
                return
            if line.startswith(_NUKE):
                self.rest.append(line)
                return
            pose = _pose(line.removeprefix(_POSE))
        except ValueError as error:
            self.rest.append(line)
            if line.strip():
                message = tr("{0}; the line is kept, but not used").format(error)
                self.findings.append(Finding(number, None, message))
            return
        count = len(pose.positions)
        if count < motors:
            text = tr("pose {0} has only {1} of {2} positions; the missing positions become {3}")
            self.warn(number, text.format(pose.name, count, motors, CENTER))
            pose = Pose(pose.name, pose.for_motors(motors))
        elif count > motors:
            text = tr(
                "pose {0} has {1} positions for {2} servos; the last positions are kept, but "
                "not used"
            )
            self.warn(number, text.format(pose.name, count, motors))
        self.poses.append((number, pose))

    def with_unique_names(self, items: list[tuple[int, ItemT]], kind: str) -> tuple[ItemT, ...]:
        """Return the items with unique names. Of equally named items, the last keeps its name.

        An item without blanks around its name has priority, because PyPose finds only such items.
        """
        taken = {item.name for _, item in items}
        by_priority = sorted(items, key=lambda item: (item[0] not in self._with_blanks, item[0]))
        last = {item.name: number for number, item in by_priority}
        next_numbers: dict[str, int] = {}
        for index, (number, item) in enumerate(items):
            if last[item.name] != number:
                first = next_numbers.get(item.name, 2)
                name, next_numbers[item.name] = numbered_name(item.name, taken, first)
                taken.add(name)
                text = tr(
                    "line {0} defines this {1} again and takes precedence; the name in this "
                    "line becomes {2}"
                )
                self.warn(number, text.format(last[item.name], tr(kind), name))
                items[index] = (number, replace(item, name=name))
        return tuple(item for _, item in items)


def _no_header() -> str:
    return tr(
        "the first line should contain the name of the robot and the number of servos; "
        "assuming 8 servos"
    )


def _pose(line: str) -> Pose:
    name, values = _name(
        line, tr("this is neither a pose nor a sequence: there is no colon"), "pose"
    )
    positions = []
    for motor, field in enumerate(_fields(values)):
        position = _number(field)
        if position is None or position > HIGHEST:
            text = tr("pose {0}: positions must be numbers from 0 to {1}, not {2!r} (motor {3})")
            raise ValueError(text.format(name, HIGHEST, field.strip(), motor))
        positions.append(position)
    return Pose(name, tuple(positions))


def _sequence(line: str) -> Sequence:
    name, values = _name(line, tr("a sequence needs a colon after its name"), "sequence")
    steps = []
    for field in _fields(values):
        pose_name, bar, time = field.strip().partition("|")
        milliseconds = _number(time)
        if not bar or milliseconds is None or not SHORTEST_MS <= milliseconds <= LONGEST_MS:
            text = tr("sequence {0}: a step must be a pose, a bar and {1} to {2} ms, not {3!r}")
            raise ValueError(text.format(name, SHORTEST_MS, LONGEST_MS, field.strip()))
        steps.append(SequenceStep(pose_name.strip(), milliseconds))
    return Sequence(name, tuple(steps))


def _name(line: str, no_colon: str, kind: str) -> tuple[str, str]:
    name, colon, values = line.partition(":")
    if not colon:
        raise ValueError(no_colon)
    if not name.strip():
        raise ValueError(tr("a {0} needs a name before the colon").format(tr(kind)))
    return name.strip(), values


def _fields(values: str) -> list[str]:
    """Split values at commas. A comma after the last value is ignored."""
    fields = values.split(",")
    if not fields[-1].strip():
        fields.pop()
    return fields


def _number(field: str) -> int | None:
    digits = field.strip(" \t")
    return int(digits) if _NUMBER.fullmatch(digits) else None
