"""All that is drawn of a recording of a robot, and what was known of it at any time."""

import math
from collections.abc import Callable, Iterable, Sequence
from copy import copy
from dataclasses import dataclass

import numpy as np

from trex_gui.core.recording.block_replay import BlockReplay
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.units import degrees
from trex_gui.devices.aracna.recording import FellSilent, Row
from trex_gui.devices.aracna.recording.csv_reader import RobotCsvFile
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    NotResponding,
    Passed,
    PlayEnded,
    StepBegun,
)
from trex_gui.devices.trex.recording.recording import Marker
from trex_gui.ui.playback.recording_loader import LoadedColumns, LoadedRecording, load_recording

MOST_ROWS = 2_000_000
"""Rows that can be drawn: two hours of a sequence at the robot's highest rate, 144 MB."""

_Drawn = tuple[float, ...]
"""A time (s) and a position for each motor (degrees; no number where it is not known)."""

_NO_GAP = math.inf
"""The robot tells where it is only when it moves: meanwhile it stands where it was."""


@dataclass(slots=True)
class Moment:
    """What was known at one time of a recording.

    Attributes:
        known: what the robot had reported.
        step: the step of what was played that had begun last; `None` while nothing was played.
    """

    known: RobotState
    step: StepBegun | None = None

    def __copy__(self) -> "Moment":
        """Return one that `take` of this one does not change."""
        known = copy(self.known)
        known.present = list(self.known.present)
        return Moment(known, self.step)

    def take(self, record: Row) -> None:
        """Take a record as the newest."""
        match record:
            case FellSilent():
                self.known.take(NotResponding())
                self.step = None
            case StepBegun():
                self.step = record
            case PlayEnded():
                self.step = None
            case Marker():
                pass
            case _:
                self.known.take(record)


def gather(
    file: RobotCsvFile, tell: Callable[[float], None], most_rows: int = MOST_ROWS
) -> LoadedRecording[BlockReplay[Row, Moment]]:
    """Read a recording of which only the head was read.

    The history has a column for each motor, in degrees: a row where a motion begins, one for each
    answer, and one wherever else something happened while nothing moved. From the beginning of a
    motion to its answer a motor's curve is straight; in between nobody knows.

    Raises:
        RecordingError: it cannot be read.
    """
    motors = file.header.motors
    replay = BlockReplay[Row, Moment](file, Moment(RobotState(motors)))
    return load_recording(file, replay, LoadedColumns(motors, _rows, most_rows, _NO_GAP), tell)


def _rows(moment: Moment, records: Iterable[Row]) -> list[_Drawn]:
    rows = list[_Drawn]()
    motion = list[tuple[int, int]]()  # of each row of a motion: its place, how many had answered
    for record in records:
        moment.take(record)
        match record:
            case Moving():
                motion = [(len(rows), 0)]
            case Passed(present=present) if motion:
                motion.append((len(rows), len(present)))
            case Moved() if motion:
                motion.append((len(rows), moment.known.motors))
            case _ if moment.known.moving is not None:
                continue
        rows.append((record.time, *map(_height, moment.known.present)))
        if moment.known.moving is None:
            _straighten(rows, motion)
            motion = []
    return rows


def _straighten(rows: list[_Drawn], motion: Sequence[tuple[int, int]]) -> None:
    """Draw every motor straight to where it answered: the others' answers say nothing of it."""
    if len(motion) < 3:
        return
    table = np.array([rows[place] for place, _ in motion])
    times = table[:, 0]
    for motor in range(table.shape[1] - 1):
        answer = next((n for n, (_, count) in enumerate(motion) if count > motor), 0)
        ends = table[[0, answer], motor + 1]
        between = slice(1, answer)
        table[between, motor + 1] = np.interp(times[between], times[[0, answer]], ends)
    for (place, _), row in zip(motion, table.tolist(), strict=True):
        rows[place] = tuple(row)


def _height(place: int | None) -> float:
    return math.nan if place is None else degrees(place)
