"""Recordings that were made to do harm are refused or read in part, with a message."""

import shutil
import sqlite3
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.devices.trex.recording.samples import an_hour, open_recording, read_file, write
from trex_gui.core.recording.kinds import RecordingError


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("crafted") / "whole.trexrec"
    write(path, list(an_hour(5)))
    return path


@pytest.fixture
def craft(whole: Path, tmp_path: Path) -> Callable[..., Path]:
    """Change a recording by SQL."""

    def change(*statements: str) -> Path:
        path = tmp_path / "crafted.trexrec"
        shutil.copy(whole, path)
        database = sqlite3.connect(path)
        for statement in statements:
            database.execute(statement)
        database.commit()
        database.close()
        return path

    return change


@pytest.mark.parametrize("clock", ["9e999", "-9e999", "1e308", "-1e308", "'soon'"])
def test_header_with_an_absurd_clock_is_rejected(craft: Callable[..., Path], clock: str) -> None:
    path = craft(f"UPDATE header SET value = {clock} WHERE key = 'clock_s'")
    with pytest.raises(RecordingError, match="It is damaged"):
        open_recording(path)


@pytest.mark.parametrize("clock", ["9e999", "-9e999", "1e308", "-1e308", "1e9"])
def test_record_with_an_absurd_time_is_left_out(craft: Callable[..., Path], clock: str) -> None:
    first = "SELECT min(record) FROM currents"
    path = craft(f"UPDATE currents SET clock_s = {clock} WHERE record = ({first})")
    _, records, problems = read_file(path)
    assert len(records) == len(list(an_hour(5))) - 1
    (problem,) = problems
    assert problem.endswith("its time is not in the recording.")


def test_computed_column_is_rejected(craft: Callable[..., Path]) -> None:
    path = craft(
        "DROP TABLE marker",
        "CREATE TABLE marker (record INTEGER PRIMARY KEY, clock_s REAL, marker_kind TEXT,"
        " time_s REAL AS (clock_s), text TEXT AS (hex(zeroblob(100000))))",
    )
    with pytest.raises(RecordingError, match=r"marker\.text is computed"):
        open_recording(path)


def test_huge_text_is_not_read(craft: Callable[..., Path]) -> None:
    clock = "SELECT value FROM header WHERE key = 'clock_s'"
    path = craft(
        "INSERT INTO marker (record, clock_s, marker_kind, text)"
        f" VALUES (100000, ({clock}), 'stop', hex(zeroblob(1000000)))"
    )
    _, records, problems = read_file(path)
    assert len(records) == len(list(an_hour(5)))
    (problem,) = problems
    assert problem.startswith("Samples of marker among records")


def test_huge_header_is_rejected(craft: Callable[..., Path]) -> None:
    path = craft("UPDATE header SET value = hex(zeroblob(40000)) WHERE key = 'settings'")
    with pytest.raises(RecordingError, match="the header is incomplete"):
        open_recording(path)
