"""Recordings of a robot and their exports."""

import csv
import json
import math
from datetime import UTC, datetime
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.aracna import recordings
from tests.devices.aracna.recordings import open_recording, read_all, records, write
from tests.support.matrix import examples
from trex_gui.core.recording.export import export_span
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.aracna.recording import Record, RobotHeader
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    NotResponding,
    Progress,
    SpeedsHeld,
    StepStarted,
)

HEADER = RobotHeader(datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC), 100.0, version=1, motors=2)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


def rows(folder: Path, *content: Record) -> list[dict[str, str]]:
    """Return the rows that a spreadsheet reads."""
    write(folder / "a.trexrec", list(content), HEADER)
    recording = open_recording(folder / "a.trexrec")
    target = folder / "a.csv"
    export_span(recording, target, (-math.inf, math.inf), recording.header.values())
    recording.close()
    with target.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@examples(25)
@given(content=st.lists(records, max_size=30))
def test_every_record_is_read_as_written(folder: Path, content: list[Record]) -> None:
    path = folder / "any.trexrec"
    assert write(path, content) == path.stat().st_size
    assert read_all(path) == (content, [])
    recording = open_recording(path)
    assert recording.header == recordings.HEADER
    recording.close()


def test_first_row_describes_robot_and_start_time(folder: Path) -> None:
    [header] = rows(folder)
    about = json.loads(header["text"])
    assert header["sample"] == "header"
    assert (about["device_name"], about["firmware"], about["motors"]) == ("Aracna", 1, 2)
    assert about["started_utc"] == "2026-01-02T03:04:05+00:00"


def test_last_goals_positions_and_speeds_fill_later_rows(folder: Path) -> None:
    _, speeds, goals, progress, moved, later, unread, silent = rows(
        folder,
        SpeedsHeld(100.5, (100, 200), (100, 200)),
        Moving(101.0, (512, 0), (None, None), 2.0),
        Progress(102.0, (510,)),
        Moved(103.0, (512, 0), (510, 1), 2.0),
        Progress(104.0, (300,)),
        Moved(105.0, (512, 6), (5, -1), 1.0),
        NotResponding(106.0),
    )
    assert (speeds["time_s"], speeds["sample"]) == ("0.500000", "speeds")
    assert speeds["motor_1_speed_units"] == "200"
    assert goals["motor_0_goal_units"] == "512"
    assert goals["motor_0_present_units"] == ""
    assert progress["motor_0_present_units"] == "510"
    assert progress["motor_0_present_deg"] == "149.6"
    assert progress["motor_1_present_units"] == ""
    assert moved["motor_1_present_units"] == "1"
    assert moved["motor_0_speed_units"] == "100"
    assert (later["motor_0_present_units"], later["motor_1_present_units"]) == ("300", "1")
    assert unread["motor_0_present_units"] == "5"
    assert unread["motor_1_present_units"] == unread["motor_1_present_deg"] == ""
    assert silent["motor_0_goal_units"] == "512"
    assert silent["motor_1_present_units"] == silent["motor_0_speed_units"] == ""


def test_steps_and_markers_are_exported(folder: Path) -> None:
    _, step, marker = rows(
        folder,
        StepStarted(101.0, "steps", 2, 0, 0.25),
        Marker(102.0, "fault", 'Motor 3, "silent"\nfor long'),
    )
    assert (step["sample"], step["part"], step["step"], step["round"]) == (
        *("step", "steps", "3", "1"),
    )
    assert step["late_s"] == "0.25"
    assert (marker["marker_kind"], marker["text"]) == ("fault", 'Motor 3, "silent"\nfor long')


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("motors", 0, "motors must be 1 to 254, not 0"),
        ("motors", 10**9, "motors must be 1 to 254, not 1000000000"),
        ("started_utc", "soon", "Invalid isoformat"),
        ("firmware", None, "int"),
    ],
)
def test_invalid_header_is_rejected_with_reason(name: str, value: object, reason: str) -> None:
    values: dict[str, object] = dict(HEADER.values())
    values[name] = value
    with pytest.raises(ValueError, match=reason):
        RobotHeader.from_values(values)
    del values[name]
    with pytest.raises(ValueError, match=f"the header is incomplete \\('{name}'\\)"):
        RobotHeader.from_values(values)
