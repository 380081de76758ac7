"""History dialog without a board."""

from collections.abc import Iterator
from datetime import timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QLabel, QLineEdit, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.support.pages.settings import HistoryDialog
from tests.support.snapshots import create_snapshot
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.history_dialog import HistoryDialog as HistoryWidget

MINUTE = timedelta(minutes=1)


@pytest.fixture
def dialog(qtbot: QtBot) -> Iterator[HistoryDialog]:
    window = QWidget()
    qtbot.addWidget(window)
    dialog = HistoryWidget(Device(), window)
    window.addAction("History", dialog.show_in_front).setObjectName("historyAction")
    yield HistoryDialog(WidgetDriver(window, qtbot))
    dialog.close()


# --- The list ---------------------------------------------------------------------------


def test_empty_history_explains_snapshots(dialog: HistoryDialog) -> None:
    (name,) = dialog.root.findChildren(QPushButton, "nameSnapshotButton")
    assert not name.isEnabled()
    dialog.open()
    empty = dialog.find(QLabel, "historyEmpty")
    dialog.wait(empty.isVisible)
    assert "Before this program or trexcmd applies settings" in empty.text()
    assert not dialog.root.isModal()


def test_newest_snapshot_is_compared_with_the_previous_one(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history, MINUTE, serial_timeout=5)
    create_snapshot(dialog.history, serial_timeout=7)
    dialog.open()
    assert dialog.values() == {"serial_timeout": ("0.5 s", "0.7 s")}
    assert "1 will change" in dialog.text("comparisonSummary")
    assert "Apply of 2 settings" in dialog.text("snapshotTitle")
    assert not dialog.is_enabled("restoreButton")
    assert "No board is connected" in dialog.text("restoreNote")
    dialog.select_snapshot(1)  # compared with the later snapshot
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("0.7 s", "0.5 s")})


def test_snapshot_gets_a_name(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history, MINUTE)
    create_snapshot(dialog.history)
    dialog.open()
    dialog.select_snapshot(1)
    dialog.click("nameSnapshotButton")
    (editor,) = dialog.snapshots.viewport().findChildren(QLineEdit)
    QTest.keyClicks(editor, "contest")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    dialog.wait_for_files()
    assert [snapshot.name for snapshot in dialog.history.snapshots()] == ["", "contest"]


def test_two_snapshots_are_compared_with_each_other(dialog: HistoryDialog) -> None:
    for minutes, wire in ((3, 5), (2, 6), (1, 7)):
        create_snapshot(dialog.history, minutes * MINUTE, serial_timeout=wire)
    dialog.open()
    dialog.select_snapshot(2, 0)
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("0.7 s", "0.5 s")})
    dialog.select_snapshot(0, 1, 2)
    dialog.wait_for_text("comparisonSummary", "two to compare")


def test_single_snapshot_shows_its_content(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history, serial_timeout=7)
    dialog.open()
    assert dialog.values()["serial_timeout"] == ("not given", "0.7 s")


def test_damaged_snapshot_is_explained_and_cannot_be_restored(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history, 2 * MINUTE)
    create_snapshot(dialog.history, MINUTE).path.write_text("rubbish\n", encoding="utf-8")
    create_snapshot(dialog.history)
    dialog.open()
    dialog.select_snapshot(1)
    dialog.wait_for_text("comparisonSummary", "is damaged and cannot be restored")
    assert not dialog.values()
    assert not dialog.is_enabled("saveSnapshotButton")
    assert not dialog.is_enabled("restoreButton")
    assert "damaged" in dialog.snapshots.model().index(1, 0).data(Qt.ItemDataRole.ToolTipRole)
    dialog.select_snapshot(0)
    dialog.wait_for_text("comparisonSummary", "No setting differs")  # from the oldest
    dialog.select_snapshot(0, 1)
    dialog.wait_for_text("comparisonSummary", "is damaged")


def test_search_filters_the_list(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history, MINUTE, reason="trexcmd set-settings rover.txt")
    create_snapshot(dialog.history)
    dialog.open()
    search = dialog.find(QLineEdit, "snapshotSearch")
    QTest.keyClicks(search, "rover")
    dialog.wait_for_files()
    assert dialog.count() == 1
    QTest.keyClicks(search, "xyz")
    dialog.wait_for_files()
    assert dialog.has("snapshotNoMatch")
    search.clear()
    dialog.wait_for_files()
    assert dialog.count() == 2


def test_changes_of_another_program_appear_on_refresh(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history, MINUTE, serial_timeout=5)
    dialog.open()
    create_snapshot(dialog.history)
    dialog.refresh()
    assert dialog.count() == 2
    assert dialog.selected_row() == 1  # the selection remains


# --- User actions -----------------------------------------------------------------------


def test_deletion_needs_confirmation_in_the_dialog(dialog: HistoryDialog) -> None:
    for minutes in (3, 2, 1):
        create_snapshot(dialog.history, minutes * MINUTE)
    dialog.open()
    dialog.select_snapshot(1)
    dialog.click("deleteSnapshotButton")
    assert not dialog.question.isWindow()
    dialog.click("deleteSnapshotButton")
    names = [button.objectName() for button in dialog.find_all(QPushButton)]
    assert names.count("historyQuestionYes") == 1
    dialog.answer(yes=False)
    assert len(dialog.history.snapshots()) == 3
    deleted = dialog.history.snapshots()[1]
    dialog.snapshots.setFocus()
    QTest.keyClick(dialog.snapshots, Qt.Key.Key_Delete)
    dialog.answer(yes=True)
    assert deleted not in dialog.history.snapshots()
    assert len(dialog.history.snapshots()) == 2
    assert dialog.selected_row() == 1  # the next snapshot


def test_deleting_the_last_snapshot_empties_the_history(dialog: HistoryDialog) -> None:
    create_snapshot(dialog.history)
    dialog.open()
    dialog.click("deleteSnapshotButton")
    dialog.root.close()
    assert len(dialog.history.snapshots()) == 1, "the user did not confirm the deletion"
    dialog.open()
    dialog.click("deleteSnapshotButton")
    dialog.answer(yes=True)
    dialog.wait(dialog.find(QLabel, "historyEmpty").isVisible)


def test_copy_is_saved_as_a_settings_file(
    dialog: HistoryDialog, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    snapshot = create_snapshot(dialog.history)
    path = tmp_path / "copy.txt"
    dialog.open()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    dialog.click("saveSnapshotButton")
    dialog.wait_for_files()
    assert path.read_bytes() == snapshot.path.read_bytes()
    assert str(path) in dialog.banner
    missing = tmp_path / "nowhere" / "copy.txt"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(missing), ""))
    dialog.click("saveSnapshotButton")
    dialog.wait_for_files()
    assert "Nothing was saved" in dialog.banner
