"""The history without a board: looking back, comparing, deleting, keeping."""

from collections.abc import Iterator
from datetime import timedelta
from pathlib import Path
from typing import TypeVar

import pytest
from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QStandardItemModel
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QLabel,
    QLineEdit,
    QPushButton,
    QSpinBox,
    QTableView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.snapshots import take
from trex_gui.model.device import Device
from trex_gui.settings.history import BOUND_FILE, Bound, History
from trex_gui.views.history.dialog import HistoryDialog
from trex_gui.views.widgets.question import Question

MINUTE = timedelta(minutes=1)
WidgetT = TypeVar("WidgetT", bound=QWidget)


@pytest.fixture
def history() -> History:
    return History()  # in a folder of the test's own


@pytest.fixture
def dialog(qtbot: QtBot) -> Iterator[HistoryDialog]:
    dialog = HistoryDialog(Device())
    qtbot.addWidget(dialog)
    yield dialog
    dialog.close()


def find(dialog: HistoryDialog, kind: type[WidgetT], name: str) -> WidgetT:
    found = dialog.findChild(kind, name)
    assert found is not None
    return found


def click(qtbot: QtBot, dialog: HistoryDialog, name: str) -> None:
    QTest.mouseClick(find(dialog, QPushButton, name), Qt.MouseButton.LeftButton)


def opened(qtbot: QtBot, dialog: HistoryDialog) -> QTableView:
    dialog.open_history()
    return find(dialog, QTableView, "snapshotView")


def choose(qtbot: QtBot, dialog: HistoryDialog, *rows: int) -> None:
    view = find(dialog, QTableView, "snapshotView")
    view.clearSelection()
    for row in rows:
        index = view.model().index(row, 0)
        select = QItemSelectionModel.SelectionFlag.Select | QItemSelectionModel.SelectionFlag.Rows
        view.selectionModel().setCurrentIndex(index, select)
    qtbot.wait(1)


def text(dialog: HistoryDialog, name: str = "comparisonSummary") -> str:
    return find(dialog, QLabel, name).text()


def compared(dialog: HistoryDialog) -> dict[str, tuple[str, str]]:
    model = find(dialog, QTableView, "comparisonTable").model()
    rows = range(model.rowCount())
    return {
        str(model.index(row, 0).data()): (model.index(row, 1).data(), model.index(row, 2).data())
        for row in rows
    }


def question(dialog: HistoryDialog) -> Question:
    return find(dialog, Question, "historyQuestion")


def answer(qtbot: QtBot, dialog: HistoryDialog, *, yes: bool) -> None:
    qtbot.waitUntil(question(dialog).isVisible)
    click(qtbot, dialog, "historyQuestionYes" if yes else "questionCancel")
    assert not question(dialog).isVisible()


# --- Looking back -----------------------------------------------------------------------


def test_an_empty_history_says_when_snapshots_are_taken(
    dialog: HistoryDialog, qtbot: QtBot
) -> None:
    dialog.open_history()
    empty = find(dialog, QLabel, "historyEmpty")
    qtbot.waitUntil(empty.isVisible)
    assert "Before each Apply" in empty.text()
    assert not dialog.isModal()


def test_the_newest_is_shown_against_the_one_before_it(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history, MINUTE, serial_timeout=5)
    take(history, serial_timeout=7)
    opened(qtbot, dialog)
    assert compared(dialog) == {"Serial Timeout": ("0.5 s", "0.7 s")}
    assert "1 setting differs" in text(dialog)
    assert "Apply of 2 settings" in text(dialog, "snapshotTitle")
    assert not find(dialog, QPushButton, "restoreButton").isEnabled()
    assert "No board is connected" in text(dialog, "restoreNote")


def test_an_older_one_is_shown_as_what_it_would_bring_back(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history, MINUTE, serial_timeout=5)
    take(history, serial_timeout=7)
    opened(qtbot, dialog)
    choose(qtbot, dialog, 1)
    qtbot.waitUntil(lambda: compared(dialog) == {"Serial Timeout": ("0.7 s", "0.5 s")})


def test_two_that_are_selected_are_compared_from_the_newer_to_the_older(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    for ago, wire in ((3, 5), (2, 6), (1, 7)):
        take(history, ago * MINUTE, serial_timeout=wire)
    opened(qtbot, dialog)
    choose(qtbot, dialog, 2, 0)
    qtbot.waitUntil(lambda: compared(dialog) == {"Serial Timeout": ("0.7 s", "0.5 s")})
    choose(qtbot, dialog, 0, 1, 2)
    qtbot.waitUntil(lambda: "two to compare" in text(dialog))


def test_any_other_snapshot_can_be_chosen_to_compare_with_and_stays_chosen(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    for ago, wire in ((3, 5), (2, 6), (1, 7)):
        take(history, ago * MINUTE, serial_timeout=wire)
    opened(qtbot, dialog)
    box = find(dialog, QComboBox, "compareWithCombo")
    model = box.model()
    assert isinstance(model, QStandardItemModel)
    assert not model.item(0).isEnabled()  # the board
    box.setCurrentIndex(box.count() - 1)
    box.activated.emit(box.currentIndex())
    assert compared(dialog) == {"Serial Timeout": ("0.5 s", "0.7 s")}
    choose(qtbot, dialog, 1)
    qtbot.waitUntil(lambda: compared(dialog) == {"Serial Timeout": ("0.5 s", "0.6 s")})


def compare_with_a_file(dialog: HistoryDialog) -> None:
    box = find(dialog, QComboBox, "compareWithCombo")
    box.setCurrentIndex(box.findText("a settings file…"))
    box.activated.emit(box.currentIndex())


def test_a_settings_file_can_be_compared_with(
    dialog: HistoryDialog,
    history: History,
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    snapshot = take(history, serial_timeout=7)
    path = tmp_path / "rover.txt"
    path.write_bytes(snapshot.path.read_bytes().replace(b"serial_timeout: 7", b"serial_timeout: 4"))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    opened(qtbot, dialog)
    compare_with_a_file(dialog)
    assert compared(dialog) == {"Serial Timeout": ("0.4 s", "0.7 s")}
    assert find(dialog, QComboBox, "compareWithCombo").currentText() == "rover.txt"


def test_a_settings_file_that_cannot_be_used_is_a_sentence(
    dialog: HistoryDialog,
    history: History,
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    take(history)
    monkeypatch.setattr(
        QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "nowhere.txt"), "")
    )
    opened(qtbot, dialog)
    compare_with_a_file(dialog)
    assert "there is no such file" in text(dialog, "bannerText")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: ("", ""))
    compare_with_a_file(dialog)


def test_the_only_one_shows_what_it_holds(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history, serial_timeout=7)
    opened(qtbot, dialog)
    assert compared(dialog)["Serial Timeout"] == ("not given", "0.7 s")
    assert "no other snapshot of a TReX" in text(dialog)


def test_of_another_product_nothing_that_means_something_else_is_compared(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history, 2 * MINUTE, model="trexjr")
    take(history, MINUTE)
    take(history)
    opened(qtbot, dialog)
    choose(qtbot, dialog, 2)
    qtbot.waitUntil(lambda: "no other snapshot of a TReX Jr" in text(dialog))


def test_a_damaged_snapshot_says_what_is_wrong_and_is_never_offered(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history, 2 * MINUTE)
    take(history, MINUTE).path.write_text("rubbish\n", encoding="utf-8")
    take(history)
    view = opened(qtbot, dialog)
    choose(qtbot, dialog, 1)
    qtbot.waitUntil(lambda: "is damaged and cannot be restored" in text(dialog))
    assert not compared(dialog)
    assert not find(dialog, QPushButton, "saveSnapshotButton").isEnabled()
    assert not find(dialog, QPushButton, "restoreButton").isEnabled()
    assert "damaged" in view.model().index(1, 0).data(Qt.ItemDataRole.ToolTipRole)
    choose(qtbot, dialog, 0)
    box = find(dialog, QComboBox, "compareWithCombo")
    qtbot.waitUntil(box.isEnabled)
    assert sum("snapshot of" in box.itemText(row) for row in range(box.count())) == 1
    choose(qtbot, dialog, 0, 1)
    qtbot.waitUntil(lambda: "is damaged" in text(dialog))


def test_the_list_is_searched(dialog: HistoryDialog, history: History, qtbot: QtBot) -> None:
    take(history, MINUTE, reason="trexcmd set-settings rover.txt")
    take(history)
    view = opened(qtbot, dialog)
    search = find(dialog, QLineEdit, "snapshotSearch")
    QTest.keyClicks(search, "rover")
    assert view.model().rowCount() == 1
    QTest.keyClicks(search, "xyz")
    assert find(dialog, QLabel, "snapshotNoMatch").isVisible()
    search.clear()
    assert view.model().rowCount() == 2


def test_a_snapshot_that_another_program_takes_shows_when_one_comes_back(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history, MINUTE, serial_timeout=5)
    view = opened(qtbot, dialog)
    take(history)
    dialog.refresh()
    assert view.model().rowCount() == 2
    (row,) = view.selectionModel().selectedRows()
    assert row.row() == 1  # what was looked at stays


# --- What a person does -----------------------------------------------------------------


def test_deleting_asks_and_does_not_stand_in_the_way(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    for ago in (3, 2, 1):
        take(history, ago * MINUTE)
    view = opened(qtbot, dialog)
    choose(qtbot, dialog, 1)
    click(qtbot, dialog, "deleteSnapshotButton")
    assert not question(dialog).isWindow()
    click(qtbot, dialog, "deleteSnapshotButton")
    assert len(dialog.findChildren(QPushButton, "historyQuestionYes")) == 1
    answer(qtbot, dialog, yes=False)
    assert len(history.snapshots()) == 3
    gone = history.snapshots()[1]
    QTest.keyClick(view, Qt.Key.Key_Delete)
    answer(qtbot, dialog, yes=True)
    assert gone not in history.snapshots()
    assert len(history.snapshots()) == 2
    (row,) = view.selectionModel().selectedRows()
    assert row.row() == 1  # what took its place


def test_the_last_one_deleted_leaves_an_empty_history(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history)
    opened(qtbot, dialog)
    click(qtbot, dialog, "deleteSnapshotButton")
    answer(qtbot, dialog, yes=True)
    qtbot.waitUntil(find(dialog, QLabel, "historyEmpty").isVisible)


def test_closing_with_a_question_open_does_nothing_of_it(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history)
    opened(qtbot, dialog)
    click(qtbot, dialog, "deleteSnapshotButton")
    dialog.close()
    assert len(history.snapshots()) == 1


def test_a_copy_is_saved_as_a_settings_file(
    dialog: HistoryDialog,
    history: History,
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    snapshot = take(history)
    path = tmp_path / "copy.txt"
    opened(qtbot, dialog)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    click(qtbot, dialog, "saveSnapshotButton")
    assert path.read_bytes() == snapshot.path.read_bytes()
    assert str(path) in text(dialog, "bannerText")
    lost = tmp_path / "nowhere" / "copy.txt"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(lost), ""))
    click(qtbot, dialog, "saveSnapshotButton")
    assert "Nothing was saved" in text(dialog, "bannerText")


# --- How many are kept ------------------------------------------------------------------


def test_a_higher_bound_is_set_without_a_question(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    dialog.open_history()
    assert not find(dialog, QPushButton, "keptButton").isEnabled()
    find(dialog, QSpinBox, "keptField").setValue(1000)
    click(qtbot, dialog, "keptButton")
    assert history.bound() == Bound(1000)
    find(dialog, QComboBox, "keptCombo").setCurrentIndex(1)
    click(qtbot, dialog, "keptButton")
    assert history.bound() == Bound(None)
    assert not find(dialog, QPushButton, "keptButton").isEnabled()
    assert not question(dialog).isVisible()


def test_a_lower_bound_asks_and_names_how_many_go(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    for ago in (3, 2, 1):
        take(history, ago * MINUTE)
    view = opened(qtbot, dialog)
    find(dialog, QSpinBox, "keptField").setValue(1)
    click(qtbot, dialog, "keptButton")
    assert question(dialog).text == "Remove the oldest 2 of 3 snapshots for good?"
    answer(qtbot, dialog, yes=False)
    assert (len(history.snapshots()), history.bound()) == (3, Bound())
    assert find(dialog, QSpinBox, "keptField").value() == 500
    find(dialog, QSpinBox, "keptField").setValue(1)
    click(qtbot, dialog, "keptButton")
    answer(qtbot, dialog, yes=True)
    assert (len(history.snapshots()), history.bound()) == (1, Bound(1))
    assert view.model().rowCount() == 1


def test_a_damaged_bound_is_told_until_it_is_set_anew(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history)
    (history.folder / BOUND_FILE).write_text("kept: some\n", encoding="utf-8")
    opened(qtbot, dialog)
    assert "none is removed" in text(dialog, "bannerText")
    find(dialog, QComboBox, "keptCombo").setCurrentIndex(0)
    find(dialog, QSpinBox, "keptField").setValue(20)
    click(qtbot, dialog, "keptButton")
    assert history.bound() == Bound(20)
    assert text(dialog, "bannerText") == ""


def test_a_bound_that_trexcmd_sets_shows_when_one_comes_back(
    dialog: HistoryDialog, history: History, qtbot: QtBot
) -> None:
    take(history)
    opened(qtbot, dialog)
    history.keep(77)
    dialog.refresh()
    assert find(dialog, QSpinBox, "keptField").value() == 77
