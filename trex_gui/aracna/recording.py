"""A session with an Aracna as CSV: what was asked, where the motors were, what happened.

The first line names the columns, with units. The second has `header` in its column `record` and
says in `text`, as JSON, of which robot the recording is. After that each line is one record:
`time_s` counts from the start, to 1 µs.

| record | what is new in it |
|---|---|
| goals | `motor_0_goal_units` …: a `.c` went out |
| present | `motor_0_present_units` … and the same in degrees: an answer, or as much of it as came |
| speeds | `motor_0_speed_units` …: what the servos hold; 0 is as fast as they can |
| step | `step`: a step of what is played begins; `text` says which |
| event | `event` is its kind, `text` is what happened |

Goals, places and speeds stand in every row as they were last known, so that a spreadsheet can
draw one column against another; those that nobody knows are empty, as are those of a motor that
did not answer.
"""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import BinaryIO

from trex_gui import __version__
from trex_gui.aracna.link.messages import Moved, Moving, Passed, SpeedsHeld, StepBegun
from trex_gui.aracna.protocol.units import DEGREES_PER_SECOND, DEGREES_PER_UNIT, degrees
from trex_gui.recording.columns import joined, plain_line
from trex_gui.recording.recording import Marker

SUFFIX = ".csv"


@dataclass(frozen=True, slots=True)
class Header:
    """Of what a recording is.

    Attributes:
        started: when, in UTC.
        clock: what the session's clock said then, in seconds.
        version: of the robot's firmware.
        motors: how many there are.
    """

    started: datetime
    clock: float
    version: int
    motors: int

    def to_json(self) -> str:
        """Return it as one line of JSON; units stand beside what they belong to."""
        return json.dumps(
            {
                "started_utc": self.started.astimezone(UTC).isoformat(),
                "clock_s": self.clock,
                "robot": "Aracna",
                "firmware": self.version,
                "motors": self.motors,
                "degrees_per_position_unit": DEGREES_PER_UNIT,
                "degrees_per_second_per_speed_unit": DEGREES_PER_SECOND,
                "program": f"TReX Studio {__version__}",
            }
        )


Row = Moving | Passed | Moved | SpeedsHeld | StepBegun | Marker
"""What is recorded, as the session reports it; times are of the session's clock."""


def columns(motors: int) -> list[str]:
    """Return the names of all columns of a recording with so many motors."""
    names = ["time_s", "record"]
    for quantity in ("goal_units", "present_units", "present_deg", "speed_units"):
        names += [f"motor_{motor}_{quantity}" for motor in range(motors)]
    return [*names, "step", "event", "text"]


class CsvWriter:
    """Writes a recording as CSV.

    Attributes:
        size: bytes handed to the file so far.
    """

    def __init__(self, file: BinaryIO, header: Header) -> None:
        self.size = 0
        self._file = file
        self._clock = header.clock
        self._motors = header.motors
        nothing = [""] * header.motors
        self._goals, self._speeds = list(nothing), list(nothing)
        self._present: list[int | None] = [None] * header.motors
        self._put(joined(columns(header.motors)))
        self._put(self._line(header.clock, "header", text=header.to_json()))

    def write(self, records: Sequence[Row]) -> None:
        lines = [self._of(record) for record in records]
        if lines:
            self._put("\n".join(lines))

    def flush(self) -> None:
        """Every row is handed on at once."""

    def finish(self) -> None:
        self._file.flush()

    def _put(self, text: str) -> None:
        data = (text + "\n").encode("utf-8", "surrogatepass")
        self._file.write(data)
        self.size += len(data)

    def _of(self, record: Row) -> str:
        match record:
            case Moving(goals=goals):
                self._goals = self._first(goals)
                return self._line(record.time, "goals")
            case Passed(present=present) | Moved(present=present):
                self._note(present)
                return self._line(record.time, "present")
            case SpeedsHeld(held=held):
                self._speeds = self._first(held)
                return self._line(record.time, "speeds")
            case StepBegun():
                text = f"{record.part}, round {record.round + 1}, {record.late:.3f} s late"
                return self._line(record.time, "step", step=str(record.index + 1), text=text)
            case Marker():
                return self._line(record.time, "event", event=record.kind, text=record.text)

    def _note(self, present: Sequence[int]) -> None:
        for motor, place in enumerate(present[: self._motors]):
            self._present[motor] = place if place >= 0 else None

    def _first(self, values: Sequence[int]) -> list[str]:
        """Return a cell for each motor; empty where a servo did not answer."""
        cells = [str(value) if value >= 0 else "" for value in values[: self._motors]]
        return cells + [""] * (self._motors - len(cells))

    def _line(
        self, time: float, record: str, *, step: str = "", event: str = "", text: str = ""
    ) -> str:
        return joined(
            [
                f"{time - self._clock:.6f}",
                record,
                *self._goals,
                *("" if place is None else str(place) for place in self._present),
                *("" if place is None else f"{degrees(place):.1f}" for place in self._present),
                *self._speeds,
                step,
                plain_line(event),
                plain_line(text),
            ]
        )
