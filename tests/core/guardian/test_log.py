"""Reading the log of guardian processes."""

from pathlib import Path

import pytest

from trex_gui.core.guardian.log import LoggedStop, StopResult, last_stop, log_file

FIRST = b"2026-11-23 12:03:05 confirmed: The program ended.\n"
LINES = FIRST + b"2026-11-24 07:00:00 unconfirmed: The program ended.\n"
NEWEST = LoggedStop("2026-11-24 07:00:00", StopResult.UNCONFIRMED)


@pytest.fixture
def log() -> Path:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    return log_file()


def test_last_stop_behind_what_was_seen_is_found(log: Path) -> None:
    log.write_bytes(LINES)
    size = len(LINES)
    assert [last_stop(seen) for seen in (0, len(FIRST), size)] == [
        (size, NEWEST),
        (size, NEWEST),
        (size, None),
    ]


def test_log_that_became_shorter_counts_as_new(log: Path) -> None:
    log.write_bytes(LINES)
    assert last_stop(1_000_000) == (len(LINES), NEWEST)


@pytest.mark.parametrize(
    "damage", [b"\xff\0\n", b"2026-11-25 07:00:00 lost: words\n", b"x" * 999_999]
)
def test_damaged_log_is_read_as_far_as_possible(log: Path, damage: bytes) -> None:
    log.write_bytes(damage + b"\n" + LINES)
    assert last_stop(0)[1] == NEWEST
    log.write_bytes(damage)
    assert last_stop(0) == (len(damage), None)


def test_missing_log_is_empty() -> None:
    assert last_stop(5) == (0, None)


def test_folder_in_place_of_the_log_is_empty(log: Path) -> None:
    log.mkdir()
    assert last_stop(0) == (0, None)
