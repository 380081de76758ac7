"""The CSV of a session: units in the headings, what was last known in every row."""

import csv
import io
import json
from datetime import UTC, datetime

from trex_gui.devices.aracna.recording import CsvWriter, Header, Row, columns
from trex_gui.devices.aracna.session.messages import Moved, Moving, Passed, SpeedsHeld, StepBegun
from trex_gui.devices.trex.recording.recording import Marker

HEADER = Header(datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC), 100.0, version=1, motors=2)


def rows(*records: Row) -> list[dict[str, str]]:
    """Return what a spreadsheet reads of these records."""
    file = io.BytesIO()
    writer = CsvWriter(file, HEADER)
    writer.write(records)
    writer.finish()
    assert writer.size == len(file.getvalue())
    return list(csv.DictReader(io.StringIO(file.getvalue().decode(), newline="")))


def test_columns_name_every_motor_and_unit() -> None:
    names = columns(8)
    assert names[0] == "time_s"
    assert len(names) == len(set(names)) == 2 + 4 * 8 + 3
    for motor in range(8):
        for quantity in ("goal_units", "present_units", "present_deg", "speed_units"):
            assert f"motor_{motor}_{quantity}" in names


def test_first_row_describes_robot_and_start_time() -> None:
    [header] = rows()
    about = json.loads(header["text"])
    assert header["record"] == "header"
    assert (about["robot"], about["firmware"], about["motors"]) == ("Aracna", 1, 2)
    assert about["started_utc"] == "2026-01-02T03:04:05+00:00"


def test_last_goals_positions_and_speeds_fill_later_rows() -> None:
    _, speeds, goals, passed, moved = rows(
        SpeedsHeld(100.5, (100, 200), (100, 200)),
        Moving(101.0, (512, 0), (None, None), 2.0),
        Passed(102.0, (510,)),
        Moved(103.0, (512, 0), (510, 1), 2.0),
    )
    assert (speeds["time_s"], speeds["record"]) == ("0.500000", "speeds")
    assert speeds["motor_1_speed_units"] == "200"
    assert goals["motor_0_goal_units"] == "512"
    assert goals["motor_0_present_units"] == ""
    assert passed["motor_0_present_units"] == "510"
    assert passed["motor_0_present_deg"] == "149.6"
    assert passed["motor_1_present_units"] == ""
    assert moved["motor_1_present_units"] == "1"
    assert moved["motor_0_speed_units"] == "100"


def test_unreadable_position_leaves_cells_empty() -> None:
    _, _, moved = rows(
        Moved(101.0, (5, 6), (5, 6), 1.0),
        Moved(102.0, (5, 6), (5, -1), 1.0),
    )
    assert moved["motor_0_present_units"] == "5"
    assert moved["motor_1_present_units"] == moved["motor_1_present_deg"] == ""


def test_steps_and_events_are_written_as_text() -> None:
    _, step, event = rows(
        StepBegun(101.0, "steps", 2, 0, 0.25),
        Marker(102.0, "fault", 'Motor 3, "silent"\nfor long'),
    )
    assert (step["record"], step["step"]) == ("step", "3")
    assert step["text"] == "steps, round 1, 0.250 s late"
    assert (event["event"], event["text"]) == ("fault", 'Motor 3, "silent"\\nfor long')
