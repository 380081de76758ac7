"""The history without a board: looking back, comparing, deleting, keeping."""

from collections.abc import Iterator
from datetime import timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QStandardItemModel
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QFileDialog,
    QLabel,
    QLineEdit,
    QPushButton,
    QSpinBox,
    QTableView,
)
from pytestqt.qtbot import QtBot

from tests.support.pages.settings import ComparisonDialog
from tests.support.snapshots import take
from trex_gui.model.device import Device
from trex_gui.settings.history import BOUND_FILE, Bound, History
from trex_gui.views.history.dialog import HistoryDialog
from trex_gui.views.widgets.question import Question

MINUTE = timedelta(minutes=1)


@pytest.fixture
def history() -> History:
    return History()  # in a folder of the test's own


class HistoryDialogDriver(ComparisonDialog):
    """The history of no board."""

    def __init__(self, qtbot: QtBot) -> None:
        self._dialog = HistoryDialog(Device())
        super().__init__(self._dialog, qtbot)
        qtbot.addWidget(self._dialog)

    def open(self) -> QTableView:
        self._dialog.open_history()
        return self.snapshots

    def refresh(self) -> None:
        self._dialog.refresh()

    @property
    def snapshots(self) -> QTableView:
        return self.find(QTableView, "snapshotView")

    @property
    def question(self) -> Question:
        return self.find(Question, "historyQuestion")

    @property
    def summary(self) -> str:
        return self.text("comparisonSummary")

    @property
    def banner(self) -> str:
        return self.text("bannerText")

    def differences(self) -> dict[str, tuple[str, str]]:
        """Return both values of each setting by its text."""
        return {row[0]: (row[1], row[2]) for row in self.rows()}

    def wait_for_differences(self, expected: dict[str, tuple[str, str]]) -> None:
        self.wait(lambda: self.differences() == expected)

    def wait_for_summary(self, part: str) -> None:
        self.wait_for_text("comparisonSummary", part)

    def select_snapshots(self, *rows: int) -> None:
        view = self.snapshots
        view.clearSelection()
        flags = QItemSelectionModel.SelectionFlag
        for row in rows:
            index = view.model().index(row, 0)
            view.selectionModel().setCurrentIndex(index, flags.Select | flags.Rows)

    def compare_with_file(self) -> None:
        box = self.combo("compareWithCombo")
        box.setCurrentIndex(box.findText("a settings file…"))
        box.activated.emit(box.currentIndex())

    def answer(self, *, yes: bool) -> None:
        self.wait(self.question.isVisible)
        self.click("historyQuestionYes" if yes else "questionCancel")
        assert not self.question.isVisible()


@pytest.fixture
def dialog(qtbot: QtBot) -> Iterator[HistoryDialogDriver]:
    dialog = HistoryDialogDriver(qtbot)
    yield dialog
    dialog.root.close()


# --- Looking back -----------------------------------------------------------------------


def test_empty_history_says_when_snapshots_are_taken(dialog: HistoryDialogDriver) -> None:
    dialog.open()
    empty = dialog.find(QLabel, "historyEmpty")
    dialog.wait(empty.isVisible)
    assert "Before each Apply" in empty.text()
    assert not dialog.root.isModal()


def test_newest_snapshot_is_compared_with_the_previous_one(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history, MINUTE, serial_timeout=5)
    take(history, serial_timeout=7)
    dialog.open()
    assert dialog.differences() == {"Serial Timeout": ("0.5 s", "0.7 s")}
    assert "1 setting differs" in dialog.summary
    assert "Apply of 2 settings" in dialog.text("snapshotTitle")
    assert not dialog.is_enabled("restoreButton")
    assert "No board is connected" in dialog.text("restoreNote")


def test_older_snapshot_shows_what_restoring_it_would_change(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history, MINUTE, serial_timeout=5)
    take(history, serial_timeout=7)
    dialog.open()
    dialog.select_snapshots(1)
    dialog.wait_for_differences({"Serial Timeout": ("0.7 s", "0.5 s")})


def test_two_snapshots_are_compared_from_newer_to_older(
    dialog: HistoryDialogDriver, history: History
) -> None:
    for ago, wire in ((3, 5), (2, 6), (1, 7)):
        take(history, ago * MINUTE, serial_timeout=wire)
    dialog.open()
    dialog.select_snapshots(2, 0)
    dialog.wait_for_differences({"Serial Timeout": ("0.7 s", "0.5 s")})
    dialog.select_snapshots(0, 1, 2)
    dialog.wait_for_summary("two to compare")


def test_reference_snapshot_can_be_selected_and_is_kept(
    dialog: HistoryDialogDriver, history: History
) -> None:
    for ago, wire in ((3, 5), (2, 6), (1, 7)):
        take(history, ago * MINUTE, serial_timeout=wire)
    dialog.open()
    box = dialog.combo("compareWithCombo")
    model = box.model()
    assert isinstance(model, QStandardItemModel)
    assert not model.item(0).isEnabled()  # the board
    box.setCurrentIndex(box.count() - 1)
    box.activated.emit(box.currentIndex())
    assert dialog.differences() == {"Serial Timeout": ("0.5 s", "0.7 s")}
    dialog.select_snapshots(1)
    dialog.wait_for_differences({"Serial Timeout": ("0.5 s", "0.6 s")})


def test_settings_file_can_be_the_reference(
    dialog: HistoryDialogDriver,
    history: History,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    snapshot = take(history, serial_timeout=7)
    path = tmp_path / "rover.txt"
    path.write_bytes(snapshot.path.read_bytes().replace(b"serial_timeout: 7", b"serial_timeout: 4"))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    dialog.open()
    dialog.compare_with_file()
    assert dialog.differences() == {"Serial Timeout": ("0.4 s", "0.7 s")}
    assert dialog.combo("compareWithCombo").currentText() == "rover.txt"


def test_missing_settings_file_is_reported(
    dialog: HistoryDialogDriver,
    history: History,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    take(history)
    monkeypatch.setattr(
        QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "nowhere.txt"), "")
    )
    dialog.open()
    dialog.compare_with_file()
    assert "there is no such file" in dialog.banner
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: ("", ""))
    dialog.compare_with_file()


def test_only_snapshot_shows_what_it_contains(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history, serial_timeout=7)
    dialog.open()
    assert dialog.differences()["Serial Timeout"] == ("not given", "0.7 s")
    assert "no other snapshot of a TReX" in dialog.summary


def test_snapshot_of_another_product_is_not_compared(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history, 2 * MINUTE, model="trexjr")
    take(history, MINUTE)
    take(history)
    dialog.open()
    dialog.select_snapshots(2)
    dialog.wait_for_summary("no other snapshot of a TReX Jr")


def test_damaged_snapshot_is_explained_and_never_offered(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history, 2 * MINUTE)
    take(history, MINUTE).path.write_text("rubbish\n", encoding="utf-8")
    take(history)
    view = dialog.open()
    dialog.select_snapshots(1)
    dialog.wait_for_summary("is damaged and cannot be restored")
    assert not dialog.differences()
    assert not dialog.is_enabled("saveSnapshotButton")
    assert not dialog.is_enabled("restoreButton")
    assert "damaged" in view.model().index(1, 0).data(Qt.ItemDataRole.ToolTipRole)
    dialog.select_snapshots(0)
    box = dialog.combo("compareWithCombo")
    dialog.wait(box.isEnabled)
    assert sum("snapshot of" in box.itemText(row) for row in range(box.count())) == 1
    dialog.select_snapshots(0, 1)
    dialog.wait_for_summary("is damaged")


def test_search_filters_the_list(dialog: HistoryDialogDriver, history: History) -> None:
    take(history, MINUTE, reason="trexcmd set-settings rover.txt")
    take(history)
    view = dialog.open()
    search = dialog.find(QLineEdit, "snapshotSearch")
    QTest.keyClicks(search, "rover")
    assert view.model().rowCount() == 1
    QTest.keyClicks(search, "xyz")
    assert dialog.has("snapshotNoMatch")
    search.clear()
    assert view.model().rowCount() == 2


def test_snapshot_of_another_program_appears_on_refresh(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history, MINUTE, serial_timeout=5)
    view = dialog.open()
    take(history)
    dialog.refresh()
    assert view.model().rowCount() == 2
    (row,) = view.selectionModel().selectedRows()
    assert row.row() == 1  # what was looked at stays


# --- What a person does -----------------------------------------------------------------


def test_deletion_needs_confirmation_in_the_dialog(
    dialog: HistoryDialogDriver, history: History
) -> None:
    for ago in (3, 2, 1):
        take(history, ago * MINUTE)
    view = dialog.open()
    dialog.select_snapshots(1)
    dialog.click("deleteSnapshotButton")
    assert not dialog.question.isWindow()
    dialog.click("deleteSnapshotButton")
    names = [button.objectName() for button in dialog.find_all(QPushButton)]
    assert names.count("historyQuestionYes") == 1
    dialog.answer(yes=False)
    assert len(history.snapshots()) == 3
    gone = history.snapshots()[1]
    QTest.keyClick(view, Qt.Key.Key_Delete)
    dialog.answer(yes=True)
    assert gone not in history.snapshots()
    assert len(history.snapshots()) == 2
    (row,) = view.selectionModel().selectedRows()
    assert row.row() == 1  # what took its place


def test_deleting_the_last_snapshot_empties_the_history(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history)
    dialog.open()
    dialog.click("deleteSnapshotButton")
    dialog.answer(yes=True)
    dialog.wait(dialog.find(QLabel, "historyEmpty").isVisible)


def test_closing_with_an_open_question_deletes_nothing(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history)
    dialog.open()
    dialog.click("deleteSnapshotButton")
    dialog.root.close()
    assert len(history.snapshots()) == 1


def test_copy_is_saved_as_a_settings_file(
    dialog: HistoryDialogDriver,
    history: History,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    snapshot = take(history)
    path = tmp_path / "copy.txt"
    dialog.open()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    dialog.click("saveSnapshotButton")
    assert path.read_bytes() == snapshot.path.read_bytes()
    assert str(path) in dialog.banner
    lost = tmp_path / "nowhere" / "copy.txt"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(lost), ""))
    dialog.click("saveSnapshotButton")
    assert "Nothing was saved" in dialog.banner


# --- How many are kept ------------------------------------------------------------------


def test_higher_bound_is_set_without_a_question(
    dialog: HistoryDialogDriver, history: History
) -> None:
    dialog.open()
    assert not dialog.is_enabled("keptButton")
    dialog.find(QSpinBox, "keptField").setValue(1000)
    dialog.click("keptButton")
    assert history.bound() == Bound(1000)
    dialog.combo("keptCombo").setCurrentIndex(1)
    dialog.click("keptButton")
    assert history.bound() == Bound(None)
    assert not dialog.is_enabled("keptButton")
    assert not dialog.question.isVisible()


def test_lower_bound_asks_and_says_how_many_are_removed(
    dialog: HistoryDialogDriver, history: History
) -> None:
    for ago in (3, 2, 1):
        take(history, ago * MINUTE)
    view = dialog.open()
    dialog.find(QSpinBox, "keptField").setValue(1)
    dialog.click("keptButton")
    assert dialog.question.text == "Remove the oldest 2 of 3 snapshots for good?"
    dialog.answer(yes=False)
    assert (len(history.snapshots()), history.bound()) == (3, Bound())
    assert dialog.find(QSpinBox, "keptField").value() == 500
    dialog.find(QSpinBox, "keptField").setValue(1)
    dialog.click("keptButton")
    dialog.answer(yes=True)
    assert (len(history.snapshots()), history.bound()) == (1, Bound(1))
    assert view.model().rowCount() == 1


def test_damaged_bound_is_reported_until_it_is_set(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history)
    (history.folder / BOUND_FILE).write_text("kept: some\n", encoding="utf-8")
    dialog.open()
    assert "none is removed" in dialog.banner
    dialog.combo("keptCombo").setCurrentIndex(0)
    dialog.find(QSpinBox, "keptField").setValue(20)
    dialog.click("keptButton")
    assert history.bound() == Bound(20)
    assert dialog.banner == ""


def test_bound_set_elsewhere_appears_on_refresh(
    dialog: HistoryDialogDriver, history: History
) -> None:
    take(history)
    dialog.open()
    history.keep(77)
    dialog.refresh()
    assert dialog.find(QSpinBox, "keptField").value() == 77
