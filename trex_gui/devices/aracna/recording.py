"""Recording format of a robot: header and sample kinds."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

from trex_gui.core.recording.kinds import (
    MARKERS,
    Column,
    Marker,
    Physical,
    RecordingFormat,
    SampleKind,
    Value,
)
from trex_gui.devices.aracna.poses.project import MAX_MOTORS
from trex_gui.devices.aracna.protocol.joints import DEGREES_PER_SECOND, DEGREES_PER_UNIT
from trex_gui.devices.aracna.protocol.replies import UNREADABLE
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Moved,
    Moving,
    NotResponding,
    PlayEnded,
    Progress,
    Restarted,
    SpeedsHeld,
    StepStarted,
    Stuck,
)
from trex_gui.version import __version__

Report = (
    Moving
    | Progress
    | Moved
    | SpeedsHeld
    | StepStarted
    | PlayEnded
    | Stuck
    | Restarted
    | NotResponding
)
"""Session reports that are recorded."""

Record = Report | Marker  # times are seconds on the session clock


@dataclass(frozen=True, slots=True)
class RobotHeader:
    """Header of a recording. `clock`: session clock in seconds at the start."""

    started: datetime
    clock: float
    version: int
    motors: int

    def values(self) -> dict[str, Value]:
        return {
            "device_name": "Aracna",
            "started_utc": self.started.astimezone(UTC).isoformat(),
            "clock_s": self.clock,
            "firmware": self.version,
            "motors": self.motors,
            "degrees_per_position_unit": DEGREES_PER_UNIT,
            "degrees_per_second_per_speed_unit": DEGREES_PER_SECOND,
            "program": f"TReX Studio {__version__}",
        }

    @classmethod
    def from_values(cls, values: Mapping[str, Any]) -> "RobotHeader":
        """Create a header. Raises ValueError if a value is missing or invalid."""
        try:
            header = cls(
                started=datetime.fromisoformat(values["started_utc"]).astimezone(UTC),
                clock=float(values["clock_s"]),
                version=int(values["firmware"]),
                motors=int(values["motors"]),
            )
        except (KeyError, TypeError, OverflowError) as error:
            raise ValueError(f"the header is incomplete ({error})") from error
        if not 1 <= header.motors <= MAX_MOTORS:
            raise ValueError(f"the number of motors must be 1 to {MAX_MOTORS}, not {header.motors}")
        return header


def sample_kinds(motors: int) -> tuple[SampleKind, ...]:
    def columns(quantity: str, description: str, *, optional: bool = False) -> tuple[Column, ...]:
        def column(motor: int) -> Column:
            name = f"motor_{motor}_{quantity}"
            is_position = quantity in {"goal", "present"}
            physical = Physical(f"{name}_deg", DEGREES_PER_UNIT, 1) if is_position else None
            text = f"motor {motor}: {description}"
            return Column(f"{name}_units", "INTEGER", text, physical, optional=optional)

        return tuple(map(column, range(motors)))

    goals = columns("goal", "commanded position, 0 to 1023 (0 to 300 degrees)")
    present = columns("present", "reported position; NULL without a reply", optional=True)

    clears = frozenset({"progress", "speeds"})

    def progress(time: float, replied: int, *cells: int | None) -> Progress:
        return Progress(time, _positions(cells[:replied]))

    def moved(time: float, seconds: float, *cells: int | None) -> Moved:
        moved_goals = tuple(cell for cell in cells[:motors] if cell is not None)
        return Moved(time, moved_goals, _positions(cells[motors:]), seconds)

    return (
        SampleKind(
            "goals",
            Moving,
            (
                Column("expected_s", "REAL", "expected duration of the motion"),
                *goals,
                *columns("start", "position at the start; NULL if unknown", optional=True),
            ),
            lambda r: (r.expected, *r.goals, *r.starts),
            lambda time, expected, *cells: Moving(time, cells[:motors], cells[motors:], expected),
            held=True,
        ),
        SampleKind(
            "progress",
            Progress,
            (Column("answered", "INTEGER", "number of motors that have replied so far"), *present),
            lambda r: (len(r.present), *_cells(r.present, motors)),
            progress,
            held=True,
            partial=True,
        ),
        SampleKind(
            "present",
            Moved,
            (Column("duration_s", "REAL", "time from the command to the reply"), *goals, *present),
            lambda r: (r.seconds, *r.goals, *_cells(r.present, motors)),
            moved,
            held=True,
        ),
        SampleKind(
            "speeds",
            SpeedsHeld,
            (
                *columns(
                    "speed", "speed reported by the servo; NULL without a reply", optional=True
                ),
                *columns("speed_setpoint", "commanded speed, 0 (unlimited) to 1023"),
            ),
            lambda r: (*_cells(r.held, motors), *r.requested),
            lambda time, *values: SpeedsHeld(time, values[motors:], _positions(values[:motors])),
            held=True,
        ),
        SampleKind(
            "step",
            StepStarted,
            (
                Column("part", "TEXT", "in, steps or out"),
                Column("step", "INTEGER", "number of the step, from 1"),
                Column("round", "INTEGER", "number of the round, from 1"),
                Column("late_s", "REAL", "delay of the start relative to the schedule"),
            ),
            lambda r: (r.part, r.index + 1, r.round + 1, r.late),
            lambda time, part, step, round_, late: StepStarted(
                time, part, step - 1, round_ - 1, late
            ),
        ),
        SampleKind(
            "play_end",
            PlayEnded,
            (Column("reason", "TEXT", ", ".join(ending.name.lower() for ending in Ending)),),
            lambda r: (r.ending.name.lower(),),
            lambda time, reason: PlayEnded(time, Ending[reason.upper()]),
        ),
        SampleKind(
            "stuck",
            Stuck,
            (
                Column(
                    "stuck_motor", "INTEGER", "awaited motor; NULL without a reply", optional=True
                ),
            ),
            lambda r: (r.motor,),
            Stuck,
        ),
        SampleKind(
            "restart",
            Restarted,
            (Column("pending_lost", "INTEGER", "1 if a pending command was lost, otherwise 0"),),
            lambda r: (int(r.voided),),
            lambda time, voided: Restarted(time, bool(voided)),
            clears=clears,
        ),
        SampleKind("not_responding", NotResponding, (), lambda _: (), NotResponding, clears=clears),
        MARKERS,
    )


def _cells(values: Sequence[int], motors: int) -> tuple[int | None, ...]:
    cells = tuple(None if value == UNREADABLE else value for value in values[:motors])
    return cells + (None,) * (motors - len(cells))


def _positions(cells: Sequence[int | None]) -> tuple[int, ...]:
    return tuple(UNREADABLE if cell is None else cell for cell in cells)


FORMAT = RecordingFormat(
    "aracna", RobotHeader.from_values, lambda header: sample_kinds(header.motors)
)
