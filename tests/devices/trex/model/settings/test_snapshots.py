"""Settings history as a Qt model."""

from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from tests.support.snapshots import ADAPTER, create_snapshot
from trex_gui.devices.trex.model.settings.snapshots import SnapshotColumn, SnapshotTable
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot
from trex_gui.ui.files import background

MINUTE = timedelta(minutes=1)


class HistoryTable(SnapshotTable):
    """Snapshot table with access to its history."""

    def __init__(self, history: SettingsHistory, qtbot: QtBot) -> None:
        super().__init__(history)
        self.history = history
        self._qtbot = qtbot

    def wait_for_threads(self) -> None:
        """Wait for the threads that list and read files."""
        self._qtbot.waitUntil(lambda: not background)


@pytest.fixture
def table(qtbot: QtBot, tmp_path: Path) -> HistoryTable:
    return HistoryTable(SettingsHistory(tmp_path / "snapshots"), qtbot)


def refresh(table: HistoryTable) -> None:
    """List the folder again, and wait for the end."""
    table.refresh()
    table.wait_for_threads()


def content_of(table: HistoryTable, snapshot: Snapshot) -> Settings | str | None:
    """Read a snapshot if necessary, and return its content."""
    if table.content_of(snapshot) is None:
        table.wait_for_threads()
    return table.content_of(snapshot)


def text(table: SnapshotTable, row: int, column: SnapshotColumn) -> str:
    return str(table.index(row, column).data())


def test_table_passes_qt_model_tester(table: HistoryTable, qtmodeltester: ModelTester) -> None:
    qtmodeltester.check(table)  # type: ignore[no-untyped-call] # of pytest-qt
    refresh(table)
    first, *_ = [create_snapshot(table.history, age * MINUTE) for age in (3, 9, 5)]
    refresh(table)
    create_snapshot(table.history)
    table.history.remove(first)
    refresh(table)
    assert table.rowCount() == 3


def test_newest_snapshot_comes_first_with_all_columns(table: HistoryTable) -> None:
    create_snapshot(table.history, 5 * MINUTE, reason="trexcmd restore-defaults")
    create_snapshot(table.history, device_number=9)
    refresh(table)
    assert text(table, 0, SnapshotColumn.REASON) == "Apply of 2 settings"
    assert text(table, 0, SnapshotColumn.BOARD) == "TReX 1.2"
    assert text(table, 0, SnapshotColumn.NUMBER) == "9"
    assert text(table, 0, SnapshotColumn.ADAPTER) == ADAPTER
    assert text(table, 1, SnapshotColumn.REASON) == "trexcmd restore-defaults"
    headings = [table.headerData(column, Qt.Orientation.Horizontal) for column in SnapshotColumn]
    assert headings == ["Time", "Name", "Note", "Before", "Board", "No.", "Adapter"]


def test_times_are_local_and_recent_days_are_named(table: HistoryTable) -> None:
    now = datetime.now().astimezone()
    noon = now.replace(hour=12, minute=3, second=0, microsecond=0)
    today, yesterday, old = (
        create_snapshot(table.history, now - noon + timedelta(days)) for days in (0, 1, 400)
    )
    refresh(table)
    assert table.time_text(today) == "today 12:03"
    assert table.time_text(yesterday) == f"yesterday {yesterday.taken.astimezone():%H:%M}"
    time = old.taken.astimezone()
    assert table.time_text(old) == f"{time.day} {time:%b %Y} {time:%H:%M}"


def test_damage_is_shown_until_the_file_is_repaired(table: HistoryTable) -> None:
    path = create_snapshot(table.history).path
    intact = path.read_text(encoding="utf-8")
    path.write_text(f"{intact}nonsense: 3\n" * 9, encoding="utf-8")
    refresh(table)
    assert not table.problem_of(table.matches[0])
    assert "more errors are not listed" in str(content_of(table, table.matches[0]))
    assert "not listed" in table.problem_of(table.matches[0])
    assert text(table, 0, SnapshotColumn.BOARD) == "damaged"
    refresh(table)
    assert table.problem_of(table.matches[0])
    path.write_text(intact, encoding="utf-8")
    refresh(table)
    assert not table.problem_of(table.matches[0])
    assert isinstance(content_of(table, table.matches[0]), Settings)

    path.write_text("rubbish", encoding="utf-8")
    refresh(table)
    assert text(table, 0, SnapshotColumn.BOARD) == "damaged"
    assert table.index(0, SnapshotColumn.BOARD).data(Qt.ItemDataRole.DecorationRole)
    assert "cannot be restored" in table.index(0, 0).data(Qt.ItemDataRole.ToolTipRole)


def test_snapshot_is_reloaded_only_after_a_file_change(table: HistoryTable) -> None:
    path = create_snapshot(table.history).path
    refresh(table)
    first = content_of(table, table.matches[0])
    refresh(table)
    assert table.content_of(table.matches[0]) is first
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("motor_mode: 0", "motor_mode: 1 "), encoding="utf-8")
    refresh(table)
    settings = content_of(table, table.matches[0])
    assert isinstance(settings, Settings)
    assert settings.parameters["motor_mode"] == 1


def test_snapshots_are_read_only_in_background_threads(
    table: HistoryTable, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In virtual time, threads run only while the test waits."""
    create_snapshot(table.history)
    refresh(table)
    calls: list[str] = []
    for name in ("files", "read_header", "load"):
        original = getattr(SettingsHistory, name)

        def record_call(*arguments: Any, name: str = name, original: Any = original) -> Any:
            calls.append(name)
            return original(*arguments)

        monkeypatch.setattr(SettingsHistory, name, record_call)
    table.refresh()
    assert table.rowCount() == 1
    assert table.content_of(table.matches[0]) is None
    assert calls == []
    table.wait_for_threads()
    assert set(calls) == {"files", "read_header", "load"}
    assert isinstance(table.content_of(table.matches[0]), Settings)


def test_neighbour_is_the_next_snapshot_of_the_same_product(table: HistoryTable) -> None:
    oldest, junior, middle, damaged, newest = (
        create_snapshot(table.history, 9 * MINUTE),
        create_snapshot(table.history, 8 * MINUTE, model="trexjr"),
        create_snapshot(table.history, 7 * MINUTE),
        create_snapshot(table.history, 6 * MINUTE),
        create_snapshot(table.history),
    )
    damaged.path.write_text("", encoding="utf-8")
    refresh(table)
    assert table.neighbor(oldest) == middle
    assert table.neighbor(middle) == newest
    assert table.neighbor(newest) == middle
    assert table.neighbor(junior) is None
    table.history.remove(newest)
    refresh(table)
    assert table.neighbor(newest) is None


@pytest.mark.parametrize(
    ("words", "count"),
    [
        *(("", 2), ("restore", 1), ("RESTORE trex", 1), ("apply ttyusb0", 1), ("today", 2)),
        *(("cp2102 9", 1), ("cp2102 apply", 0)),
    ],
)
def test_search_words_match_in_every_column(table: HistoryTable, words: str, count: int) -> None:
    now = datetime.now().astimezone()
    noon = now - now.replace(hour=12)
    create_snapshot(table.history, noon)
    create_snapshot(
        table.history, noon, reason="restore-defaults", adapter="CP2102 (COM9)", device_number=9
    )
    refresh(table)
    table.set_search_text(words)
    assert table.rowCount() == count


def test_name_and_note_are_edited_in_the_table(table: HistoryTable) -> None:
    create_snapshot(table.history)
    refresh(table)
    for column, value in ((SnapshotColumn.NAME, "contest"), (SnapshotColumn.NOTE, "it won")):
        index = table.index(0, column)
        assert table.flags(index) & Qt.ItemFlag.ItemIsEditable
        assert table.setData(index, value)
        table.wait_for_threads()
        assert text(table, 0, column) == value
    assert not table.flags(table.index(0, SnapshotColumn.BOARD)) & Qt.ItemFlag.ItemIsEditable
    name = table.index(0, SnapshotColumn.NAME)
    assert not table.setData(name, "contest"), "the name is unchanged"
