"""The recording of a robot as CSV: what is written is read back, what is damaged is told."""

import csv
import json
from datetime import UTC, datetime
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.devices.aracna.recordings import HEADER, T0, assert_equal, read, rows, session, write
from tests.devices.trex.recording import samples
from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.aracna.recording import Header, Row
from trex_gui.devices.aracna.recording.csv_reader import RobotCsvFile, open_recording
from trex_gui.devices.aracna.session.messages import Moved, Moving, Passed, SpeedsHeld
from trex_gui.devices.trex.recording import csv_format, files
from trex_gui.devices.trex.recording.columns import joined
from trex_gui.devices.trex.recording.recording import Marker


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


def lines(path: Path) -> list[str]:
    return path.read_text(encoding="utf-8").splitlines()


def put(path: Path, text: list[str]) -> None:
    path.write_text("\n".join(text) + "\n", encoding="utf-8")


@settings(deadline=None)  # files on a disk that others use, too
@given(what=st.lists(rows, max_size=60))
def test_every_row_is_read_back(folder: Path, what: list[Row]) -> None:
    path = folder / "any.csv"
    assert write(path, what) == path.stat().st_size
    file = RobotCsvFile(path)
    assert file.header == HEADER
    assert_equal(read(file), what)
    assert file.problems == []
    file.close()


def test_any_block_can_be_read_separately(folder: Path) -> None:
    what = list(session(400))
    path = folder / "long.csv"
    write(path, what)
    file = RobotCsvFile(path)
    assert len(file.blocks) > 3
    for index in (len(file.blocks) - 1, 2, 0):
        assert_equal(file.read(index), what[1000 * index : 1000 * (index + 1)])
    file.close()


def test_open_reads_only_header_until_scan(folder: Path) -> None:
    path = folder / "head.csv"
    write(path, list(session()))
    file = open_recording(path)
    assert file.header == HEADER
    assert file.blocks == []
    shares: list[float] = []
    file.look_through(shares.append)
    assert len(read(file)) == len(list(session()))
    file.close()


@settings(deadline=None)  # files on a disk that others use, too
@given(share=st.floats(0, 1))
def test_truncated_file_is_read_up_to_last_complete_row(folder: Path, share: float) -> None:
    what = list(session(5))
    path = folder / "cut.csv"
    write(path, what)
    data = path.read_bytes()
    cut = int(share * len(data))
    path.write_bytes(data[:cut])
    whole = data[:cut].count(b"\n")
    try:
        file = RobotCsvFile(path)
    except RecordingError:
        assert whole < 2
        return
    found = read(file)
    assert_equal(found, what[: whole - 2])
    is_cut = not data[:cut].endswith(b"\n")
    assert file.problems == ([f"Line {whole + 1}, the last one, is cut off."] if is_cut else [])
    file.close()


@settings(deadline=None)  # files on a disk that others use, too
@given(share=st.floats(0, 1), bits=st.integers(1, 255))
def test_flipped_byte_raises_only_recording_error(folder: Path, share: float, bits: int) -> None:
    path = folder / "flipped.csv"
    write(path, list(session(5)))
    data = bytearray(path.read_bytes())
    data[int(share * (len(data) - 1))] ^= bits
    path.write_bytes(data)
    try:
        file = RobotCsvFile(path)
    except RecordingError:
        return
    read(file)
    file.close()


MOVE: list[Row] = [
    Moving(T0 + 1, (500,) * 8, (None,) * 8, 2.0),
    Passed(T0 + 2, (499, -1)),
    Moved(T0 + 3, (500,) * 8, (499, -1, *(500,) * 6), 2.0),
    SpeedsHeld(T0 + 4, (100,) * 8, (100,) * 8),
]


@pytest.mark.parametrize(
    ("line", "old", "new", "reason"),
    [
        (3, ",goals,500,", ",goals,5oo,", "'5oo' is no number of the robot"),
        (3, ",goals,500,", ",goals,,", "the goal of motor 0 is missing"),
        (3, ",goals,500,", ",goals,0500,", "'0500' is no number of the robot"),
        (3, ",goals,", ",moves,", "there is no record 'moves'"),
        (3, "2.000000 s expected", "soon expected", "says nothing of this record"),
        (3, "from ? ", "from ", "it tells from where 7 motors go, not 8"),
        (4, "2 motors so far", "9 motors so far", "it tells of 9 motors, and there are 8"),
        (5, "all motors in 2.000000 s", "some motors", "says nothing of this record"),
        (6, "asked for 100 ", "asked for ", "it asks 7 motors, not 8"),
        (6, ",speeds,", ",speeds,7,", "it has 38 cells, not 37"),
        (6, "4.000000,", "nan,", "its time is no number"),
    ],
)
def test_invalid_row_is_skipped_and_reported_with_line(
    tmp_path: Path, line: int, old: str, new: str, reason: str
) -> None:
    path = tmp_path / "odd.csv"
    write(path, [*MOVE, Marker(T0 + 5, "stop", 'a, "b"\nc\\n')])
    text = lines(path)
    assert old in text[line - 1]
    text[line - 1] = text[line - 1].replace(old, new)
    put(path, text)
    file = RobotCsvFile(path)
    found = read(file)
    [problem] = file.problems
    assert problem.startswith(f"Line {line} cannot be understood: ")
    assert reason in problem
    assert len(found) == len(MOVE)
    assert found[-1] == Marker(T0 + 5, "stop", 'a, "b"\nc\\n')
    file.close()


def test_rows_without_text_are_read_from_their_columns(tmp_path: Path) -> None:
    path = tmp_path / "early.csv"
    write(path, MOVE)
    with path.open(encoding="utf-8", newline="") as source:
        cells = list(csv.reader(source))
    put(path, [joined(row) if at < 2 else joined([*row[:-1], ""]) for at, row in enumerate(cells)])
    file = RobotCsvFile(path)
    goals, first, last, speeds = read(file)
    assert goals == Moving(T0 + 1, (500,) * 8, (None,) * 8, 0.0)
    assert first == Moved(T0 + 2, (500,) * 8, (499, *(-1,) * 7), 0.0)
    assert last == Moved(T0 + 3, (500,) * 8, (499, -1, *(500,) * 6), 0.0)
    assert speeds == SpeedsHeld(T0 + 4, (100,) * 8, (100,) * 8)
    assert file.problems == []
    file.close()


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("robot", "Asimo", "it is of 'Asimo', not of Aracna"),
        ("motors", 0, "0 motors are not 1 to"),
        ("motors", 10**9, "1000000000 motors are not 1 to"),
        ("clock_s", float("inf"), "its time is no number"),
        ("started_utc", "soon", "Invalid isoformat"),
        ("firmware", None, "int"),
    ],
)
def test_invalid_header_is_rejected_with_reason(name: str, value: object, reason: str) -> None:
    about = json.loads(HEADER.to_json())
    about[name] = value
    with pytest.raises(ValueError, match=reason):
        Header.from_json(json.dumps(about))
    del about[name]
    with pytest.raises(ValueError, match=f"it lacks '{name}'"):
        Header.from_json(json.dumps(about))


def test_header_without_line_end_is_rejected_as_truncated(tmp_path: Path) -> None:
    path = tmp_path / "cut.csv"
    write(path, [])
    path.write_bytes(path.read_bytes().removesuffix(b"\n"))
    with pytest.raises(RecordingError, match=r"line 2: The header .* it is cut off"):
        RobotCsvFile(path)


def test_missing_column_is_named(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    write(path, [])
    put(path, [line.replace("motor_3_goal_units", "motor_3_wish") for line in lines(path)])
    with pytest.raises(RecordingError, match="The column motor_3_goal_units is missing"):
        RobotCsvFile(path)


@pytest.mark.parametrize("suffix", [".csv", ".trexrec"])
def test_trex_recording_is_rejected_with_its_device(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"board{suffix}"
    if suffix == ".csv":
        with path.open("wb") as file:
            csv_format.CsvWriter(file, samples.HEADER).write(list(samples.an_hour(1)))
    else:
        samples.write(path, list(samples.an_hour(1)))
    with pytest.raises(RecordingError) as refused:
        open_recording(path)
    assert "a recording of another device: TReX 1.2. It opens where" in str(refused.value)


def test_aracna_recording_is_rejected_by_trex_reader(tmp_path: Path) -> None:
    path = tmp_path / "robot.csv"
    write(path, list(session(2)))
    with pytest.raises(RecordingError) as refused:
        files.open_recording(path)
    assert "a recording of another device: Aracna. It opens where" in str(refused.value)


@pytest.mark.parametrize(
    "data", [b"", b"time_s,motor\n1,2\n", b"time_s,record\n", b"\x00\xff" * 400, b'time_s,"\n']
)
def test_other_file_is_rejected_with_its_name(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "other.csv"
    path.write_bytes(data)
    with pytest.raises(RecordingError, match=r"other\.csv, line [12]: "):
        open_recording(path)


def test_missing_file_is_rejected_with_reason(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="No such file"):
        open_recording(tmp_path / "none.csv")


def test_header_survives_json_round_trip() -> None:
    header = Header(datetime(2026, 5, 6, tzinfo=UTC), 3.5, version=0, motors=2)
    assert Header.from_json(header.to_json()) == header
