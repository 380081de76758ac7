"""Reading a recording of an Aracna that was written as CSV."""

import re
from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path

from trex_gui.core.recording import csv_blocks
from trex_gui.core.recording.csv_blocks import CsvBlocks
from trex_gui.devices.aracna.recording import rows
from trex_gui.devices.aracna.recording.csv_format import GOAL, PRESENT, SPEED, column, columns
from trex_gui.devices.aracna.recording.header import Header
from trex_gui.devices.aracna.recording.rows import FellSilent, Row
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    Passed,
    PlayEnded,
    Restarted,
    SpeedsHeld,
    StepBegun,
    Stuck,
)
from trex_gui.devices.trex.recording.columns import several_lines
from trex_gui.devices.trex.recording.recording import Marker

_STEP = re.compile(r"[1-9]\d{0,8}")


class RobotCsvFile(CsvBlocks[Header, Row]):
    """A recording of a robot in a CSV file.

    A file whose rows have no text, as earlier versions wrote them, is read as far as its columns
    tell: an answer counts as a whole one, and what was asked of the servos as what they hold.
    """

    kind_column = "record"

    def header_of(self, text: str) -> Header:
        return Header.from_json(text)

    def columns(self) -> Sequence[str]:
        return columns(self.header.motors)

    def record_of(self, kind: str, time: float, row: csv_blocks.Row) -> Row:
        make = _MAKERS.get(kind)
        if make is None:
            raise ValueError(f"there is no record {kind!r}")
        return make(time, _Cells(row, self.header.motors))


def open_recording(path: Path) -> RobotCsvFile:
    """Open a recording of a robot, of which only the head is read.

    Raises:
        RecordingError: there is none that can be read; says which device's it is, where it is
            another's.
    """
    return RobotCsvFile(path, head_only=True)


@lru_cache(maxsize=1024)
def _columns_of(quantity: str, motors: int) -> tuple[str, ...]:
    """Return the names of the columns of the first motors."""
    return tuple(column(motor, quantity) for motor in range(motors))


class _Cells:
    """The cells of a row of so many motors, as what they mean."""

    def __init__(self, row: csv_blocks.Row, motors: int) -> None:
        self._row = row
        self.motors = motors
        self.text = several_lines(row["text"])

    def __getitem__(self, name: str) -> str:
        return self._row[name]

    def values(self, quantity: str, motors: int | None = None) -> tuple[int, ...]:
        """Return a value for each of the first motors; -1 where the cell is empty."""
        count = self.motors if motors is None else motors
        if count > self.motors:
            raise ValueError(f"it tells of {count} motors, and there are {self.motors}")
        cells = [self._row[name] for name in _columns_of(quantity, count)]
        return tuple(rows.number_in(cell) if cell else -1 for cell in cells)

    def goals(self) -> tuple[int, ...]:
        """Return where each motor was sent; none is missing."""
        goals = self.values(GOAL)
        if -1 in goals:
            raise ValueError(f"the goal of motor {goals.index(-1)} is missing")
        return goals


def _goals(time: float, cells: _Cells) -> Moving:
    goals = cells.goals()
    if not cells.text:
        starts = tuple(None if place < 0 else place for place in cells.values(PRESENT))
        return Moving(time, goals, starts, 0.0)
    expected, starts = rows.read_goals(cells.text)
    if len(starts) != cells.motors:
        raise ValueError(f"it tells from where {len(starts)} motors go, not {cells.motors}")
    return Moving(time, goals, starts, expected)


def _present(time: float, cells: _Cells) -> Passed | Moved:
    motors, seconds = rows.read_present(cells.text) if cells.text else (None, 0.0)
    present = cells.values(PRESENT, motors)
    if motors is not None or (not cells.text and -1 in cells.values(GOAL)):
        return Passed(time, present)
    return Moved(time, cells.goals(), present, seconds)


def _speeds(time: float, cells: _Cells) -> SpeedsHeld:
    held = cells.values(SPEED)
    wanted = rows.read_speeds(cells.text) if cells.text else held
    if len(wanted) != cells.motors:
        raise ValueError(f"it asks {len(wanted)} motors, not {cells.motors}")
    return SpeedsHeld(time, wanted, held)


def _step(time: float, cells: _Cells) -> StepBegun:
    part, often, late = rows.read_step(cells.text)
    if not _STEP.fullmatch(cells["step"]):
        raise ValueError(f"{cells['step']!r} is no step")
    return StepBegun(time, part, int(cells["step"]) - 1, often, late)


_MAKERS: dict[str, Callable[[float, _Cells], Row]] = {
    "goals": _goals,
    "present": _present,
    "speeds": _speeds,
    "step": _step,
    "ended": lambda time, cells: PlayEnded(time, rows.read_ending(cells.text)),
    "stuck": lambda time, cells: Stuck(time, rows.read_stuck(cells.text)),
    "restart": lambda time, cells: Restarted(time, rows.read_restart(cells.text)),
    "silence": lambda time, _: FellSilent(time),
    "event": lambda time, cells: Marker(time, several_lines(cells["event"]), cells.text),
}
