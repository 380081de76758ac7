"""A session with an Aracna as CSV: what was asked, where the motors were, what happened.

The first line names the columns, with units. The second has `header` in its column `record` and
says in `text`, as JSON, of which robot the recording is. After that each line is one record:
`time_s` counts from the start, to 1 µs.

| record | what is new in it |
|---|---|
| goals | `motor_0_goal_units` …: a `.c` went out; `text`: how long it should take, from where |
| present | `motor_0_present_units` … and the same in degrees: an answer, or as much of it as |
|         | came; `text` says which |
| speeds | `motor_0_speed_units` …: what the servos hold; 0 is as fast as they can |
| step | `step`: a step of what is played begins; `text` says which |
| ended | nothing is played any more; `text` says why |
| stuck | the robot waits for a motor; `text` says for which |
| restart | the board has restarted: places and speeds are not known any more |
| silence | the robot has stopped answering: the same |
| event | `event` is its kind, `text` is what happened |

Goals, places and speeds stand in every row as they were last known, so that a spreadsheet can
draw one column against another; those that nobody knows are empty, as are those of a motor that
did not answer.
"""

from collections.abc import Sequence
from typing import BinaryIO

from trex_gui.core.recording.csv_lines import CsvLines
from trex_gui.devices.aracna.protocol.units import degrees
from trex_gui.devices.aracna.recording import rows
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
from trex_gui.devices.trex.recording.columns import joined, plain_line
from trex_gui.devices.trex.recording.recording import Marker

SUFFIX = ".csv"
GOAL, PRESENT, DEGREES, SPEED = "goal_units", "present_units", "present_deg", "speed_units"


def column(motor: int, quantity: str) -> str:
    """Return the name of the column of one motor."""
    return f"motor_{motor}_{quantity}"


def columns(motors: int) -> list[str]:
    """Return the names of all columns of a recording with so many motors."""
    names = ["time_s", "record"]
    for quantity in (GOAL, PRESENT, DEGREES, SPEED):
        names += [column(motor, quantity) for motor in range(motors)]
    return [*names, "step", "event", "text"]


class CsvWriter(CsvLines[Row]):
    """Writes a recording of a robot as CSV."""

    def __init__(self, file: BinaryIO, header: Header) -> None:
        super().__init__(file)
        self._clock = header.clock
        self._motors = header.motors
        self._goals = self._cells(())
        self._speeds = self._cells(())
        self._present: list[int | None] = [None] * header.motors
        self.put(joined(columns(header.motors)))
        self.put(self._line(header.clock, "header", text=header.to_json()))

    def line_of(self, record: Row) -> str:
        time = record.time
        match record:
            case Moving(goals=goals):
                self._goals = self._cells(goals)
                return self._line(time, "goals", text=rows.goals_text(record))
            case Passed(present=present):
                self._note(present)
                return self._line(time, "present", text=rows.passed_text(record))
            case Moved(goals=goals, present=present):
                self._goals = self._cells(goals)
                self._note(present)
                return self._line(time, "present", text=rows.moved_text(record))
            case SpeedsHeld(held=held):
                self._speeds = self._cells(held)
                return self._line(time, "speeds", text=rows.speeds_text(record))
            case StepBegun(index=index):
                return self._line(time, "step", step=str(index + 1), text=rows.step_text(record))
            case PlayEnded():
                return self._line(time, "ended", text=rows.ending_text(record))
            case Stuck():
                return self._line(time, "stuck", text=rows.stuck_text(record))
            case Restarted():
                self._forget()
                return self._line(time, "restart", text=rows.restart_text(record))
            case FellSilent():
                self._forget()
                return self._line(time, "silence")
            case Marker(kind=kind, text=text):
                return self._line(time, "event", event=kind, text=text)

    def _note(self, present: Sequence[int]) -> None:
        for motor, place in enumerate(present[: self._motors]):
            self._present[motor] = place if place >= 0 else None

    def _forget(self) -> None:
        self._present = [None] * self._motors
        self._speeds = self._cells(())

    def _cells(self, values: Sequence[int]) -> list[str]:
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
