"""Drivers for settings: review, power cycle, files, history."""

from pathlib import Path

import pytest
from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QLabel, QMessageBox, QTableView, QWidget
from pytestqt.qtbot import QtBot

from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.devices.trex.model.settings.comparison_table import ComparisonColumn
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.history_dialog import HistoryDialog as HistoryWidget
from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets.behaviour import ConfirmButton
from trex_gui.ui.widgets.messages import InlinePrompt


def findings_of(shown: WidgetDriver, where: str) -> list[str]:
    """Return the texts of the visible findings in a page or dialog."""
    labels = [each for each in shown.find_all(QLabel) if each.isVisible()]
    return [each.text() for each in labels if each.objectName().startswith(f"{where}Finding")]


class ComparisonDialog(WidgetDriver):
    """Dialog that compares two values of each setting in a table."""

    @property
    def table(self) -> QTableView:
        return self.find(QTableView, "comparisonTable")

    def rows(self) -> list[list[str]]:
        """Return the text of every cell."""
        model = self.table.model()
        return [
            [str(model.index(row, column).data()) for column in range(model.columnCount())]
            for row in range(model.rowCount())
        ]

    def values(self) -> dict[str, tuple[str, str]]:
        """Return both values of each setting, by key."""
        model = self.table.model()
        keys = [
            model.index(row, 0).data(Qt.ItemDataRole.UserRole) for row in range(model.rowCount())
        ]
        return {key: (row[1], row[2]) for key, row in zip(keys, self.rows(), strict=True)}

    def tick_all(self, checked: bool) -> None:
        """Check or clear every box."""
        view = self.find_only(ComparisonView)
        view.table.tick_all(checked)

    def toggle(self, setting: str) -> None:
        """Check or clear the box of a setting with the keyboard."""
        row = [row[0] for row in self.rows()].index(setting)
        self.table.setCurrentIndex(self.table.model().index(row, ComparisonColumn.SETTING))
        QTest.keyClick(self.table, Qt.Key.Key_Space)


class ReviewDialog(ComparisonDialog):
    """Review of edits before writing, and its result."""

    def __init__(self, window: WindowDriver) -> None:
        super().__init__(window.dialog("reviewDialog").root, window.qtbot)
        self._window = window

    @property
    def head(self) -> str:
        """Texts about the write, the board and problems."""
        return " ".join(map(self.text, ("reviewHead", "reviewCaption", "reviewTrouble")))

    def open(self) -> None:
        self._window.click("applyButton")
        self.wait(self.root.isVisible)
        self.wait(lambda: self.find(ConfirmButton, "writeButton").accepts_clicks)

    def write(self) -> None:
        """Open the review, write the checked edits, and wait for the result."""
        self.open()
        self.click("writeButton")
        self.wait_for_text("reviewHead", "written and verified")

    def close(self) -> None:
        self.click("reviewCloseButton")
        assert not self.root.isVisible()


class SimulatedPower:
    """Power switch of a simulated board. Each method waits until the program reacts."""

    def __init__(self, window: WindowDriver, simulator: SimulatedDevice) -> None:
        self._window = window
        self._simulator = simulator

    def off(self) -> None:
        self._simulator.do("power off")
        self._window.wait(lambda: self._window.device.link is ConnectionState.NOT_RESPONDING)

    def on(self) -> None:
        self._simulator.do("power on")
        self._window.wait(lambda: self._window.device.link is ConnectionState.CONNECTED)

    def cycle(self) -> None:
        self.off()
        self.on()


class LoadDialog(ComparisonDialog):
    """Dialog that compares a settings file with the board."""

    def findings(self) -> list[str]:
        return findings_of(self, "load")

    def button_text(self) -> str:
        return self.button("takeChangesButton").text().replace("&", "")


class SettingsFiles:
    """Settings files of the window."""

    def __init__(self, window: WindowDriver) -> None:
        self._window = window
        self.files = trex(window.program).workspace.files

    def load(self, path: Path, data: str | bytes | None = None) -> LoadDialog:
        """Open a file, if necessary after writing `data` to it. Return the dialog."""
        if data is not None:
            path.write_bytes(data if isinstance(data, bytes) else data.encode())
        self.files.open_file(path)
        self._window.wait_for_files()
        return self.load_dialog()

    def save(self, path: Path) -> None:
        """Save the displayed settings."""
        self.files.saver.save_file(path)
        self._window.wait_for_files()

    def load_dialogs(self) -> list[LoadDialog]:
        """Return the visible load dialogs."""
        return [
            LoadDialog(dialog, self._window.qtbot)
            for dialog in self._window.find_all(QDialog)
            if dialog.objectName() == "loadSettingsDialog" and dialog.isVisible()
        ]

    def load_dialog(self) -> LoadDialog:
        """Return the only visible load dialog."""
        (dialog,) = self.load_dialogs()
        return dialog

    def editor(self) -> "SettingsEditorWindow":
        """Return the only editor."""
        (editor,) = self.files.editors
        return SettingsEditorWindow(editor, self._window.qtbot)


class SettingsEditorWindow(WidgetDriver):
    """Window of a settings file."""

    def __init__(self, editor: SettingsEditor, qtbot: QtBot) -> None:
        super().__init__(editor, qtbot)
        self.editor = editor
        self.document = editor.document

    def action(self, key: str) -> QAction:
        """Return the menu entry with this key."""
        return self.find(QAction, f"editor{key}Action")

    def edit(self, key: str, value: int) -> None:
        """Change a parameter to a wire value."""
        self.document.draft.parameters.edit(key, value)


class HistoryDialog(ComparisonDialog):
    """Dialog of snapshots, opened from the menu of a window."""

    def __init__(self, window: WidgetDriver) -> None:
        self.widget = window.find(HistoryWidget, "historyDialog")
        super().__init__(self.widget, window.qtbot)
        self._action = window.find(QAction, "historyAction")
        self.history = SettingsHistory()

    def open(self) -> None:
        self._action.trigger()
        self.wait(self.root.isVisible)
        self.wait_for_files()

    def refresh(self) -> None:
        self.widget.refresh()
        self.wait_for_files()

    @property
    def snapshots(self) -> QTableView:
        return self.find(QTableView, "snapshotView")

    @property
    def question(self) -> InlinePrompt:
        return self.find(InlinePrompt, "historyQuestion")

    @property
    def banner(self) -> str:
        return self.text("bannerText")

    def count(self) -> int:
        """Return the number of listed snapshots."""
        return self.snapshots.model().rowCount()

    def selected_row(self) -> int:
        """Return the row of the only selected snapshot."""
        (row,) = self.snapshots.selectionModel().selectedRows()
        return row.row()

    def select_snapshot(self, *rows: int) -> None:
        """Select snapshots."""
        view = self.snapshots
        view.clearSelection()
        flags = QItemSelectionModel.SelectionFlag
        for row in rows:
            index = view.model().index(row, 0)
            view.selectionModel().setCurrentIndex(index, flags.Select | flags.Rows)
        self.wait_for_files()

    def answer(self, *, yes: bool) -> None:
        self.wait(self.question.isVisible)
        self.click("historyQuestionYes" if yes else "questionCancel")
        assert not self.question.isVisible()
        self.wait_for_files()

    def check_only(self, setting: str) -> None:
        self.tick_all(False)
        self.toggle(setting)


def answer_questions(
    monkeypatch: pytest.MonkeyPatch, button: QMessageBox.StandardButton
) -> list[str]:
    """Press this button in every question dialog. Return the list of questions."""
    questions: list[str] = []

    def question(_window: QWidget, _title: str, text: str, *_: object) -> object:
        questions.append(text)
        return button

    monkeypatch.setattr(QMessageBox, "question", question)
    return questions
