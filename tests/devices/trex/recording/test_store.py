"""Recordings as databases: reading, crashes, and damaged files."""

import contextlib
import errno
import shutil
import sqlite3
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.recording.samples import (
    HEADER,
    any_record,
    drive_records,
    open_recording,
    read_file,
    write,
)
from tests.support.matrix import examples
from trex_gui.core.recording.kinds import Marker, RecordingError
from trex_gui.core.recording.store import CHUNK, RecordingWriter, copy_recording
from trex_gui.devices.trex.client.telemetry import Currents, ModeSample, Raw, Sample
from trex_gui.devices.trex.recording import FORMAT, Header, Record

NOT_CLOSED = [
    "The recording was not closed properly. Samples from the last seconds may be missing."
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "a.trexrec"


@pytest.fixture(scope="module")
def ten_seconds(folder: Path) -> tuple[bytes, list[Record]]:
    """A recording of two chunks, and its records."""
    records = list(drive_records(10))
    write(folder / "ten.trexrec", records)
    return (folder / "ten.trexrec").read_bytes(), records


@examples(20)
@given(records=st.lists(any_record, max_size=60), step=st.integers(1, 20))
def test_every_record_is_read_as_written(folder: Path, records: list[Record], step: int) -> None:
    path = folder / "any.trexrec"
    assert write(path, records, step=step) == path.stat().st_size
    assert read_file(path) == (HEADER, records, [])


@pytest.mark.slow
def test_hour_at_full_rate_is_read_back_unchanged(folder: Path) -> None:
    records = list(drive_records())
    assert len(records) > 680_000
    path = folder / "hour.trexrec"
    assert write(path, records) == path.stat().st_size < 18_000_000
    assert read_file(path) == (HEADER, records, [])


def test_chunks_are_read_in_any_order(
    folder: Path, ten_seconds: tuple[bytes, list[Record]]
) -> None:
    _, records = ten_seconds
    recording = open_recording(folder / "ten.trexrec")
    for first in reversed(range(0, len(records), CHUNK)):
        assert recording.read(first + 1, first + CHUNK) == records[first : first + CHUNK]
    recording.close()


def test_tables_are_readable_without_the_program(
    folder: Path, ten_seconds: tuple[bytes, list[Record]]
) -> None:
    _, records = ten_seconds
    with contextlib.closing(sqlite3.connect(folder / "ten.trexrec")) as database:
        rows = database.execute("SELECT time_s, motor_1_current_A FROM currents").fetchall()
        header = dict(database.execute("SELECT key, value FROM header"))
        tables = database.execute("SELECT name, sql FROM sqlite_master WHERE type = 'table'")
        schema = dict(tables.fetchall())
    currents = [record for record in records if isinstance(record, Currents)]
    assert rows == [
        (pytest.approx(each.time - HEADER.clock, abs=1e-6), pytest.approx(each.counts[0] * 0.15))
        for each in currents
    ]
    assert (header["device"], header["device_name"]) == ("trex", "TReX 1.2")
    assert header["ampere_per_count"] == HEADER.model.current_unit
    assert {"raw", "remapped", "setpoint", "aux_setpoint", "marker", "settings"} < set(schema)
    assert "motor_2_current_counts INTEGER NOT NULL, -- current of motor 2" in schema["currents"]


def test_undecodable_port_name_does_not_end_the_recording(path: Path) -> None:
    write(path, [Marker(1300.0, "link", "/dev/\udce9 is closed.")])
    assert read_file(path)[1] == [Marker(1300.0, "link", "/dev/\\udce9 is closed.")]


# --- Crash, power failure, full disk ----------------------------------------------------


def crash(
    folder: Path,
    *,
    synced: Sequence[Record] = (),
    committed: Sequence[Record] = (),
    written: Sequence[Record] = (),
) -> Path:
    """Record, and copy the recording and its log in their state after a crash."""
    writer = RecordingWriter[Header, Record](folder / "a.trexrec", FORMAT, HEADER)
    writer.write(synced)
    writer.sync()
    for first in range(0, len(committed), 50):
        writer.write(committed[first : first + 50])
        writer.commit()
    writer.write(written)
    crashed = folder / "crashed"
    crashed.mkdir(exist_ok=True)
    for file in folder.glob("a.trexrec*"):
        if not file.name.endswith("-shm"):
            shutil.copy(file, crashed)
    writer.close()
    return crashed / "a.trexrec"


def test_committed_records_survive_a_crash(tmp_path: Path) -> None:
    records = list(drive_records(2))
    path = crash(tmp_path, committed=records[:100], written=records[100:])
    assert read_file(path) == (HEADER, records[:100], NOT_CLOSED)


@examples(15)
@given(share=st.floats(0, 1))
def test_power_failure_keeps_records_up_to_the_last_sync(folder: Path, share: float) -> None:
    """The main file is complete up to the last sync. The log may end anywhere."""
    records = list(drive_records(3))
    path = crash(folder, synced=records[:200], committed=records[200:])
    log = path.with_name("a.trexrec-wal")
    data = log.read_bytes()
    log.write_bytes(data[: int(share * len(data))])
    header, found, problems = read_file(path)
    assert (header, problems) == (HEADER, NOT_CLOSED)
    assert found == records[: len(found)]
    assert len(found) >= 200
    assert len(found) % 50 == 0 or found == records


def test_recording_without_its_log_is_readable(tmp_path: Path) -> None:
    records = list(drive_records(2))
    path = crash(tmp_path, synced=records[:100], committed=records[100:])
    path.with_name("a.trexrec-wal").unlink()
    assert read_file(path) == (HEADER, records[:100], NOT_CLOSED)


def test_recording_in_progress_is_rejected(path: Path) -> None:
    records = list(drive_records(1))
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)
    writer.write(records)
    writer.commit()
    with pytest.raises(RecordingError, match="still running"):
        open_recording(path)
    writer.write(records)
    writer.finish()
    writer.close()
    assert read_file(path) == (HEADER, records * 2, [])


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="needs /proc")
def test_recording_maps_no_file_into_the_process(path: Path) -> None:
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)
    writer.write(list(drive_records(1)))
    writer.commit()
    assert str(path) not in Path("/proc/self/maps").read_text(encoding="utf-8")
    writer.finish()
    writer.close()


def test_full_disk_is_reported(path: Path) -> None:
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)
    writer._database.execute("PRAGMA max_page_count = 40")
    with pytest.raises(RecordingError, match=r"a\.trexrec: .*: No space left on device\."):
        writer.write(list(drive_records(60)))
    writer.close()
    assert read_file(path) == (HEADER, [], NOT_CLOSED)


def test_existing_recording_is_replaced_with_its_log(path: Path, tmp_path: Path) -> None:
    old = RecordingWriter[Header, Record](path, FORMAT, HEADER)
    old.write(list(drive_records(5)))
    old.commit()
    shutil.copy(path.with_name("a.trexrec-wal"), tmp_path / "log")
    old.close()
    (tmp_path / "log").rename(path.with_name("a.trexrec-wal"))
    write(path, [Marker(1300.0, "note", "new")])
    assert read_file(path) == (HEADER, [Marker(1300.0, "note", "new")], [])
    assert [file.name for file in tmp_path.iterdir()] == ["a.trexrec"]


def test_recording_is_copied_with_its_log(tmp_path: Path) -> None:
    records = list(drive_records(2))
    copy = tmp_path / "copy.trexrec"
    copy_recording(crash(tmp_path, committed=records), copy)
    assert read_file(copy) == (HEADER, records, NOT_CLOSED)
    assert [file.name for file in tmp_path.glob("*copy*")] == ["copy.trexrec"]


def test_copy_replaces_a_recording_and_its_log(path: Path, tmp_path: Path) -> None:
    target = crash(tmp_path, committed=list(drive_records(2)))
    new: list[Record] = [Marker(1300.0, "note", "new")]
    write(path, new)
    copy_recording(path, target)
    assert read_file(target) == (HEADER, new, [])


@pytest.mark.parametrize("name", ["/dev/full", "/dev/null"])
def test_device_files_are_not_replaced(name: str) -> None:
    if not Path(name).exists():
        pytest.skip(f"this system has no {name}")
    with pytest.raises(RecordingError, match="not an ordinary file"):
        RecordingWriter[Header, Record](Path(name), FORMAT, HEADER)


# --- Damaged files, and files of other programs -----------------------------------------


@examples(20)
@given(share=st.floats(0, 1))
def test_cut_file_is_read_as_far_as_possible(
    folder: Path, ten_seconds: tuple[bytes, list[Record]], share: float
) -> None:
    data, records = ten_seconds
    path = folder / "cut.trexrec"
    path.write_bytes(data[: int(share * (len(data) - 1))])
    try:
        header, found, problems = read_file(path)
    except RecordingError:
        return
    assert header == HEADER
    assert "The end of the file is missing." in problems
    assert len(set(found) - set(records)) <= 1, "only the record at the cut may be wrong"


def test_cut_file_keeps_its_intact_samples(
    folder: Path, ten_seconds: tuple[bytes, list[Record]]
) -> None:
    data, records = ten_seconds
    path = folder / "half.trexrec"
    path.write_bytes(data[: len(data) * 9 // 10])
    _, found, problems = read_file(path)
    assert problems
    assert len(found) > len(records) // 4


@examples(25)
@given(share=st.floats(0, 1), bits=st.integers(1, 255), second=st.floats(0, 1))
def test_flipped_bytes_raise_only_recording_errors(
    folder: Path,
    ten_seconds: tuple[bytes, list[Record]],
    share: float,
    bits: int,
    second: float,
) -> None:
    data, records = ten_seconds
    path = folder / "flipped.trexrec"
    damaged = bytearray(data)
    for position in (share, second):
        damaged[int(position * (len(data) - 1))] ^= bits
    path.write_bytes(damaged)
    with contextlib.suppress(RecordingError):
        _, found, problems = read_file(path)
        assert len(found) <= len(records) + 2
        assert problems or len(found) >= len(records) - 400


def execute(path: Path, script: str) -> None:
    """Execute SQL statements in a database."""
    with contextlib.closing(sqlite3.connect(path)) as database:
        database.executescript(script)


def test_database_of_another_program_is_rejected(path: Path) -> None:
    execute(path, "CREATE TABLE header (key, value)")
    with pytest.raises(RecordingError, match="not a TReX Studio recording"):
        open_recording(path)


@pytest.mark.parametrize(
    ("statement", "message"),
    [
        ("PRAGMA user_version = 2", r"format of the file \(2\) is unknown. A later version"),
        ("DROP TABLE marker", "The table marker is missing"),
        ("DELETE FROM header WHERE key = 'model'", r"the header is incomplete \('model'\)"),
        ("UPDATE header SET value = 'no' WHERE key = 'model'", "the header is incomplete"),
        ("UPDATE header SET value = 'soon' WHERE key = 'started_utc'", "Invalid isoformat"),
        *(
            (f"UPDATE header SET value = {clock} WHERE key = 'clock_s'", "The file is damaged")
            for clock in ("9e999", "-9e999", "1e308", "-1e308", "'soon'")
        ),
        (
            "UPDATE header SET value = hex(zeroblob(40000)) WHERE key = 'settings'",
            "the header is incomplete",
        ),
        (
            (
                "DROP TABLE marker;"
                "CREATE TABLE marker (record INTEGER PRIMARY KEY, clock_s REAL, marker_kind TEXT,"
                " time_s REAL AS (clock_s), text TEXT AS (hex(zeroblob(100000))))"
            ),
            r"marker\.text is computed",
        ),
        (
            "UPDATE header SET value = 'Mule 2' WHERE key LIKE 'device%'",
            "a recording of another device: Mule 2. Select the port or the demo of that device",
        ),
    ],
)
def test_unusable_file_is_rejected_with_reason(path: Path, statement: str, message: str) -> None:
    write(path, list(drive_records(1)))
    execute(path, statement)
    with pytest.raises(RecordingError, match=message):
        open_recording(path)


@pytest.mark.parametrize(
    ("statement", "lost", "problem"),
    [
        ("DROP TABLE raw", Raw, "The table raw is missing."),
        (
            "ALTER TABLE mode RENAME COLUMN mode TO x",
            ModeSample,
            "The column mode.mode is missing.",
        ),
    ],
)
def test_recording_without_one_kind_of_sample_is_read(
    path: Path, statement: str, lost: type[Sample], problem: str
) -> None:
    """A version that did not poll this value may have written it."""
    records = list(drive_records(1))
    write(path, records)
    execute(path, statement)
    _, found, problems = read_file(path)
    assert found == [record for record in records if not isinstance(record, lost)]
    assert problems == [problem]


@pytest.mark.parametrize(
    ("statement", "problem"),
    [
        ("UPDATE mode SET mode = 'x'", "'x' is not a valid Mode"),
        ("UPDATE mode SET clock_s = 'noon'", "its time is not a number"),
        *(
            (f"UPDATE mode SET clock_s = {clock}", "its time is outside the recording.")
            for clock in ("9e999", "-9e999", "1e308", "-1e308", "1e9")
        ),
        ("UPDATE mode SET mode = x'00'", "mode is not of type TEXT"),
    ],
)
def test_damaged_record_is_skipped_and_reported(path: Path, statement: str, problem: str) -> None:
    records = list(drive_records(0.9))
    write(path, records)
    execute(path, statement)
    _, found, (reported,) = read_file(path)
    assert len(found) == len(records) - 1
    assert reported.startswith("Record ")
    assert problem in reported


def test_huge_text_is_not_read(path: Path) -> None:
    records = list(drive_records(1))
    write(path, records)
    clock = "SELECT value FROM header WHERE key = 'clock_s'"
    execute(
        path,
        "INSERT INTO marker (record, clock_s, marker_kind, text)"
        f" VALUES (100000, ({clock}), 'stop', hex(zeroblob(1000000)))",
    )
    _, found, (problem,) = read_file(path)
    assert found == records
    assert problem.startswith("Samples of the kind marker between records")


def test_huge_record_number_does_not_enlarge_the_recording(path: Path) -> None:
    write(path, list(drive_records(1)))
    execute(path, f"UPDATE mode SET record = {1 << 62}")
    recording = open_recording(path)
    assert recording.count <= path.stat().st_size
    recording.close()


def test_unreadable_path_raises_recording_error(folder: Path) -> None:
    with pytest.raises(RecordingError, match="cannot be opened: No such file"):
        open_recording(folder / "none.trexrec")
    with pytest.raises(RecordingError):
        open_recording(folder)
    with pytest.raises(RecordingError, match="cannot be written: No such file"):
        write(folder / "none" / "a.trexrec", [])


def test_csv_export_is_rejected_with_explanation(folder: Path) -> None:
    path = folder / "span.CSV"
    path.write_text("time_s,sample\n", encoding="utf-8")
    with pytest.raises(RecordingError, match="A CSV file is an export and cannot be opened"):
        open_recording(path)


def test_disk_that_fails_while_reading_is_reported(folder: Path) -> None:
    write(folder / "a.trexrec", list(drive_records(1)))
    recording = open_recording(folder / "a.trexrec")
    recording.close()
    with pytest.raises(RecordingError, match=r"a\.trexrec: The file cannot be read"):
        recording.read(1, CHUNK)


@pytest.fixture
def read_only_records(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Record]:
    """Records of a crashed recording on a read-only medium. Its log contains the second half."""
    records = list(drive_records(1))
    half = len(records) // 2
    crash(tmp_path, synced=records[:half], committed=records[half:])
    connect = sqlite3.connect

    def fail(location: str, **options: Any) -> sqlite3.Connection:
        if f"{tmp_path.as_uri()}/" in location and "mode=ro" in location:
            raise sqlite3.OperationalError("unable to open database file")
        database: sqlite3.Connection = connect(location, **options)
        return database

    monkeypatch.setattr(sqlite3, "connect", fail)
    return records


def test_crashed_recording_on_read_only_medium_is_complete(
    tmp_path: Path, read_only_records: list[Record]
) -> None:
    path = tmp_path / "crashed" / "a.trexrec"
    assert read_file(path) == (HEADER, read_only_records, NOT_CLOSED)


def test_log_that_cannot_be_copied_is_reported(
    tmp_path: Path, read_only_records: list[Record], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(source: Path, target: Path) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(shutil, "copyfile", fail)
    _, found, problems = read_file(tmp_path / "crashed" / "a.trexrec")
    assert found == read_only_records[: len(read_only_records) // 2]
    assert problems == [
        "The log of the recording cannot be read, so the last samples are missing.",
        *NOT_CLOSED,
    ]
