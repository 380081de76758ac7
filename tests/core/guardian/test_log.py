from pathlib import Path

import pytest

from trex_gui.core.guardian.log import StopResult, log_file, logged_stops

FIRST = b"2026-11-23 12:03:05 confirmed: The program ended.\n"
LINES = FIRST + b"2026-11-24 07:00:00 unconfirmed: The program ended.\n"
OLDEST = ("2026-11-23 12:03:05", StopResult.CONFIRMED)
NEWEST = ("2026-11-24 07:00:00", StopResult.UNCONFIRMED)


@pytest.fixture
def log() -> Path:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    return log_file()


def test_stops_after_seen_bytes_are_returned(log: Path) -> None:
    log.write_bytes(LINES)
    size = len(LINES)
    assert [logged_stops(seen) for seen in (0, len(FIRST), size)] == [
        (size, [OLDEST, NEWEST]),
        (size, [NEWEST]),
        (size, []),
    ]


def test_shorter_log_counts_as_new(log: Path) -> None:
    log.write_bytes(LINES)
    assert logged_stops(1_000_000) == (len(LINES), [OLDEST, NEWEST])


@pytest.mark.parametrize(
    "damage",
    [
        b"\xff\0\n",
        b"2026-11-25 07:00:00 lost: words\n",
        b"a 2026-11-25 07:00:00 confirmed: words\n",
        b"x" * 999_999,
    ],
)
def test_damaged_log_is_read_as_far_as_possible(log: Path, damage: bytes) -> None:
    log.write_bytes(damage + b"\n" + LINES)
    assert logged_stops(0)[1] == [OLDEST, NEWEST]
    log.write_bytes(damage)
    assert logged_stops(0) == (len(damage), [])


def test_missing_log_or_folder_in_its_place_counts_as_empty(log: Path) -> None:
    assert logged_stops(5) == (0, [])
    log.mkdir()
    assert logged_stops(0) == (0, [])
