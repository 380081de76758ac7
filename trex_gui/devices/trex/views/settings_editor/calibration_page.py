"""The calibrations of a settings file: look, change, add and leave out."""

from typing import cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Slot,
)
from PySide6.QtGui import QFont, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.devices.trex.model.calibration.table import CalibrationRole, CalibrationTable
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, row
from trex_gui.ui.widgets.labels import Note

Index = QModelIndex | QPersistentModelIndex


class _Delegate(QStyledItemDelegate):
    """Edits counts in physical units; lets edits stand out and what is not given stand back."""

    def __init__(self, page: "CalibrationEditor") -> None:
        super().__init__(page)
        self._page = page

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        del option
        key = CalibrationKey(index.data(CalibrationRole.KEY))
        editor = CountEditor(key.source, parent)
        editor.setObjectName("countEditor")
        editor.rejected.connect(self._page.say)
        return editor

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep an editor open while its input is not a value."""
        if (
            isinstance(watched, CountEditor)
            and isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.KeyPress
            and event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab}
            and not watched.hasAcceptableInput()
        ):
            watched.report_problem()
            return True
        return super().eventFilter(watched, event)

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        cast("CountEditor", editor).setValue(index.data(Qt.ItemDataRole.EditRole))

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        box = cast("CountEditor", editor)
        box.interpretText()
        model.setData(index, box.value(), Qt.ItemDataRole.EditRole)

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        font: QFont = option.font
        if index.data(CalibrationRole.DIRTY):
            font.setBold(True)
            if index.column() == 0:
                option.icon = icon("edited")
                option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration
        elif index.column() > 0 and index.data(Qt.ItemDataRole.EditRole) is None:
            font.setItalic(True)
        option.font = font


class CalibrationEditor(QWidget):
    """A table of ten rows, and what can be done with the selected ones."""

    def __init__(self, draft: SettingsDraft, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("editorCalibrationPage")
        self._table = CalibrationTable(draft, self)

        self._about = QLabel(
            self.tr(
                "A board keeps two calibrations for each channel: one for RC pulses, one for "
                "analog voltages. The file needs none: those that it does not give stay as the "
                "board has them. The count stored in the file is in brackets."
            ),
            self,
        )
        self._about.setWordWrap(True)
        self._view = QTableView(self)
        self._view.setObjectName("calibrationsView")
        self._view.setAccessibleName(self.tr("Calibrations"))
        self._view.setModel(self._table)
        self._view.setItemDelegate(_Delegate(self))
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self._view.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        self._view.setAlternatingRowColors(True)
        self._view.setShowGrid(False)
        self._view.setTabKeyNavigation(False)
        self._view.verticalHeader().hide()
        self._view.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 12)
        header = self._view.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setMinimumSectionSize(17 * self.fontMetrics().averageCharWidth())
        self._note = Note(2, self)
        self._note.setObjectName("calibrationsNote")
        self._add = button(
            self,
            "addCalibrationButton",
            self.tr("&Add selected"),
            tip=self.tr("Give the usual calibration for the selected channels"),
        )
        self._leave_out = button(
            self,
            "leaveOutCalibrationButton",
            self.tr("&Leave out selected"),
            icon="clear",
            tip=self.tr("The file then leaves these channels as they are"),
        )

        below = row((self._note, 1), self._add, self._leave_out)
        column(self._about, (self._view, 1), below, into=self)

        self._add.clicked.connect(lambda: self._table.add(self._selected()))
        self._leave_out.clicked.connect(lambda: self._table.leave_out(self._selected()))
        self._table.rejected.connect(self.say)
        self._table.dataChanged.connect(self._on_changed)
        self._view.selectionModel().selectionChanged.connect(self._on_selected)
        theme().changed.connect(self._view.viewport().update)
        self._on_changed()

    @Slot(str)
    def say(self, words: str) -> None:
        """Say why an edit was not taken."""
        self._note.show_note(words, alarming=True)

    def _selected(self) -> tuple[CalibrationKey, ...]:
        rows = {index.row(): index for index in self._view.selectionModel().selectedIndexes()}
        return tuple(CalibrationKey(rows[row].data(CalibrationRole.KEY)) for row in sorted(rows))

    @Slot()
    def _on_changed(self) -> None:
        self._note.show_note(
            self.tr("Double-click a value to change it; type 1500, 1.5 ms, 2.5 V or 3750 counts.")
        )
        self._on_selected()

    @Slot()
    def _on_selected(self) -> None:
        given = [self._table.is_given(key) for key in self._selected()]
        self._add.setEnabled(not all(given))
        self._leave_out.setEnabled(any(given))
