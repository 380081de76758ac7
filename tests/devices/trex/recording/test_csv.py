"""The recording as CSV: what spreadsheets read can be read back."""

import csv
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.devices.trex.recording.samples import HEADER, an_hour, read, records
from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.trex.client.telemetry import Currents
from trex_gui.devices.trex.recording.csv_format import CsvWriter
from trex_gui.devices.trex.recording.csv_reader import CsvFile
from trex_gui.devices.trex.recording.files import open_recording
from trex_gui.devices.trex.recording.recording import Marker, Record

RESOLUTION = 1e-6
"""Seconds to which times are written."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


def write(path: Path, what: list[Record], step: int = 1000) -> int:
    with path.open("wb") as file:
        writer = CsvWriter(file, HEADER)
        for at in range(0, len(what), step):
            writer.write(what[at : at + step])
        writer.finish()
        return writer.size


def timeless(what: list[Record]) -> list[tuple[object, ...]]:
    """Records without their times."""
    return [
        (type(record), *(getattr(record, name) for name in record.__slots__ if name != "time"))
        for record in what
    ]


def assert_equal(found: list[Record], what: list[Record]) -> None:
    assert timeless(found) == timeless(what)
    for one, other in zip(found, what, strict=True):
        late = abs(one.time - other.time)
        assert late <= RESOLUTION + abs(other.time) * 1e-15


@settings(deadline=None)  # files on a disk that others use, too
@given(what=st.lists(records.filter(lambda record: abs(record.time) < 1e6), max_size=60))
def test_every_row_can_be_read_back(folder: Path, what: list[Record]) -> None:
    path = folder / "any.csv"
    write(path, what, step=7)
    file = open_recording(path)
    assert isinstance(file, CsvFile)
    assert file.header == HEADER
    assert_equal(read(file), what)
    assert file.problems == []
    file.close()


@pytest.mark.slow
def test_hour_at_full_rate_is_read_back_unchanged(folder: Path) -> None:
    what = list(an_hour())
    path = folder / "hour.csv"
    size = write(path, what)
    assert size == path.stat().st_size
    file = CsvFile(path)
    assert len(file.blocks) > 600
    assert_equal(read(file), what)
    backwards = [file.read(index) for index in (len(file.blocks) - 1, 3, 0)]
    assert_equal(backwards[2], what[:1000])
    assert_equal(backwards[1], what[3000:4000])
    assert_equal(backwards[0][-1:], what[-1:])
    file.close()
    path.unlink()


def test_header_has_units_and_rows_repeat_last_values(
    folder: Path,
) -> None:
    path = folder / "sheet.csv"
    write(path, list(an_hour(2)))
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {"time_s", "motor_1_current_A", "channel_1_us", "channel_1_remapped"} <= set(rows[0])
    assert rows[0]["sample"] == "header"
    assert '"settings": "product: TReX' in rows[0]["text"]
    last = rows[-1]
    assert float(last["time_s"]) == pytest.approx(2, abs=0.1)
    assert float(last["channel_1_us"]) == pytest.approx(1500, abs=1)
    assert float(last["motor_2_current_A"]) >= 0
    assert last["channel_5_raw"] == ""
    assert all(None not in row for row in rows)


@settings(deadline=None)  # files on a disk that others use, too
@given(share=st.floats(0, 1))
def test_cut_file_is_read_up_to_its_last_whole_row(folder: Path, share: float) -> None:
    what = list(an_hour(1))
    path = folder / "cut.csv"
    write(path, what)
    data = path.read_bytes()
    cut = int(share * len(data))
    path.write_bytes(data[:cut])
    try:
        file = open_recording(path)
    except RecordingError:
        assert data[:cut].count(b"\n") < 2
        return
    found = read(file)
    assert_equal(found, what[: len(found)])
    assert len(found) == data[:cut].count(b"\n") - 2
    assert bool(file.problems) == (not data[:cut].endswith(b"\n"))
    file.close()


@settings(deadline=None)  # files on a disk that others use, too
@given(share=st.floats(0, 1), bits=st.integers(1, 255))
def test_flipped_byte_raises_only_recording_error(folder: Path, share: float, bits: int) -> None:
    path = folder / "flipped.csv"
    write(path, list(an_hour(1)))
    data = bytearray(path.read_bytes())
    data[int(share * (len(data) - 1))] ^= bits
    path.write_bytes(data)
    try:
        file = open_recording(path)
    except RecordingError:
        return
    read(file)
    file.close()


def test_invalid_row_is_skipped_and_reported(folder: Path) -> None:
    path = folder / "odd.csv"
    write(path, [Currents(1235.0, (1, 2)), Marker(1236.0, "stop", 'a, "b"\nc\\n')])
    text = path.read_text(encoding="utf-8").splitlines()
    text.insert(3, text[2].replace("currents", "voltages"))
    path.write_text("\n".join(text) + "\n", encoding="utf-8")
    file = CsvFile(path)
    assert len(read(file)) == 2
    assert file.problems == ["Line 4 cannot be understood: there is no sample 'voltages'."]
    assert read(file)[1] == Marker(1236.0, "stop", 'a, "b"\nc\\n')
    file.close()


def test_other_csv_file_is_rejected_with_its_name(folder: Path) -> None:
    path = folder / "other.csv"
    path.write_text("time_s,motor\n1,2\n", encoding="utf-8")
    with pytest.raises(RecordingError, match=r"other\.csv, line 1: This is no recording"):
        open_recording(path)
