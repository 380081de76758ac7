"""The history as Qt sees it."""

from datetime import datetime, timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import QPersistentModelIndex, Qt
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from tests.support.snapshots import ADAPTER, take
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.model.settings.snapshots import (
    SnapshotColumn,
    SnapshotFilter,
    SnapshotRole,
    SnapshotTable,
)
from trex_gui.devices.trex.settings.history import SettingsHistory

MINUTE = timedelta(minutes=1)
DAY = timedelta(days=1)


@pytest.fixture
def history(tmp_path: Path) -> SettingsHistory:
    return SettingsHistory(tmp_path / "snapshots")


@pytest.fixture
def table(qtbot: QtBot, history: SettingsHistory) -> SnapshotTable:
    return SnapshotTable(history)


def text(table: SnapshotTable, row: int, column: SnapshotColumn) -> str:
    return str(table.index(row, column).data())


def test_table_passes_qt_model_tester(
    table: SnapshotTable, history: SettingsHistory, qtmodeltester: ModelTester
) -> None:
    qtmodeltester.check(table)  # type: ignore[no-untyped-call] # of pytest-qt
    table.refresh()
    first, *_ = [take(history, ago * MINUTE) for ago in (3, 9, 5)]
    table.refresh()
    take(history)
    history.remove(first)
    table.refresh()
    assert table.rowCount() == 3


def test_newest_snapshot_comes_first_with_all_columns(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    take(history, 5 * MINUTE, reason="trexcmd restore-defaults")
    take(history, device_number=9)
    table.refresh()
    assert text(table, 0, SnapshotColumn.REASON) == "Apply of 2 settings"
    assert text(table, 0, SnapshotColumn.BOARD) == "TReX 1.2"
    assert text(table, 0, SnapshotColumn.NUMBER) == "9"
    assert text(table, 0, SnapshotColumn.ADAPTER) == ADAPTER
    assert text(table, 1, SnapshotColumn.REASON) == "trexcmd restore-defaults"
    heads = [table.headerData(column, Qt.Orientation.Horizontal) for column in SnapshotColumn]
    assert heads == ["Time", "Before", "Board", "No.", "Adapter"]


def test_times_are_local_and_recent_days_are_named(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    noon = datetime.now().astimezone().replace(hour=12, minute=3, second=0, microsecond=0)
    now = datetime.now().astimezone()
    taken = [take(history, now - noon + days * DAY) for days in (0, 1, 400)]
    table.refresh()
    assert table.time_text(taken[0]) == "today 12:03"
    assert table.time_text(taken[1]) == f"yesterday {taken[1].taken.astimezone():%H:%M}"
    long_ago = taken[2].taken.astimezone()
    assert table.time_text(taken[2]) == f"{long_ago.day} {long_ago:%b %Y} {long_ago:%H:%M}"


def test_snapshots_of_one_minute_show_seconds(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    noon = datetime.now().astimezone().replace(hour=12, minute=3, second=1, microsecond=0)
    now = datetime.now().astimezone()
    taken = [take(history, now - noon - timedelta(seconds=seconds)) for seconds in (0, 30)]
    table.refresh()
    times = [text(table, row, SnapshotColumn.TIME) for row in range(2)]
    assert times == [f"today 12:03:{one.taken.astimezone():%S}" for one in reversed(taken)]


def test_refresh_keeps_persistent_indexes(
    table: SnapshotTable, history: SettingsHistory, qtbot: QtBot
) -> None:
    kept, gone = take(history, 2 * MINUTE), take(history, 3 * MINUTE)
    table.refresh()
    place = QPersistentModelIndex(table.index(0, 0))
    history.remove(gone)
    newest = take(history)
    with qtbot.assertNotEmitted(table.modelReset):
        table.refresh()
    assert [snapshot.path for snapshot in table.snapshots] == [newest.path, kept.path]
    assert place.row() == 1
    assert table.row_of(gone.path) is None


def test_damaged_header_is_shown_after_refresh(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    take(history).path.write_text("rubbish", encoding="utf-8")
    table.refresh()
    assert text(table, 0, SnapshotColumn.BOARD) == "damaged"
    assert table.index(0, 0).data(SnapshotRole.PROBLEM)
    assert "cannot be restored" in table.index(0, 0).data(Qt.ItemDataRole.ToolTipRole)


def test_damaged_body_is_shown_from_load_until_repair(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    snapshot = take(history)
    sound = snapshot.path.read_text(encoding="utf-8")
    snapshot.path.write_text(f"{sound}nonsense: 3\n" * 9, encoding="utf-8")
    table.refresh()
    assert not table.problem_of(snapshot)
    with pytest.raises(SettingsError):
        table.load(snapshot)
    assert "And " in table.problem_of(snapshot)
    assert text(table, 0, SnapshotColumn.BOARD) == "damaged"
    table.refresh()
    assert table.problem_of(snapshot)
    snapshot.path.write_text(sound, encoding="utf-8")
    table.refresh()
    assert not table.problem_of(snapshot)
    assert table.load(snapshot).product.name == "TReX"


def test_snapshot_is_reloaded_only_after_a_file_change(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    snapshot = take(history)
    first = table.load(snapshot)
    assert table.load(snapshot) is first
    text = snapshot.path.read_text(encoding="utf-8")
    snapshot.path.write_text(text.replace("motor_mode: 0", "motor_mode: 1 "), encoding="utf-8")
    assert table.load(snapshot).parameters["motor_mode"] == 1


def test_neighbour_is_next_newer_or_older_of_same_product(
    table: SnapshotTable, history: SettingsHistory
) -> None:
    oldest, junior, middle, damaged, newest = (
        take(history, 9 * MINUTE),
        take(history, 8 * MINUTE, model="trexjr"),
        take(history, 7 * MINUTE),
        take(history, 6 * MINUTE),
        take(history),
    )
    damaged.path.write_text("", encoding="utf-8")
    table.refresh()
    assert table.neighbour(oldest) == middle
    assert table.neighbour(middle) == newest
    assert table.neighbour(newest) == middle
    assert table.neighbour(junior) is None
    history.remove(newest)
    table.refresh()
    assert table.neighbour(newest) is None


@pytest.mark.parametrize(
    ("words", "count"),
    [
        *(("", 2), ("restore", 1), ("RESTORE trex", 1), ("apply ttyusb0", 1), ("today", 2)),
        *(("cp2102 9", 1), ("cp2102 apply", 0)),
    ],
)
def test_words_match_in_every_column(
    table: SnapshotTable, history: SettingsHistory, words: str, count: int
) -> None:
    now = datetime.now().astimezone()
    noon = now - now.replace(hour=12)
    take(history, noon)
    take(history, noon, reason="restore-defaults", adapter="CP2102 (COM9)", device_number=9)
    table.refresh()
    shown = SnapshotFilter(table)
    shown.set_words(words)
    assert shown.rowCount() == count
