"""The calibrations of a settings file."""

from typing import cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Slot,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.devices.trex.model.calibration.table import CalibrationRole, CalibrationTable
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.views.count_editor import CountEditor, UnitDelegate
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets.builders import button, column, flat_table, label, named, row
from trex_gui.ui.widgets.labels import Note

Index = QModelIndex | QPersistentModelIndex


class _Delegate(UnitDelegate):
    """Edits counts in physical units; edits are bold, calibrations that are not given italic."""

    def __init__(self, page: "CalibrationEditor") -> None:
        super().__init__(page)
        self._page = page

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        del option
        key = CalibrationKey(index.data(CalibrationRole.KEY))
        editor = CountEditor(key.source, parent)
        editor.setObjectName("countEditor")
        editor.rejected.connect(self._page.show_problem)
        return editor

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        cast("CountEditor", editor).setValue(index.data(Qt.ItemDataRole.EditRole))

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        box = cast("CountEditor", editor)
        box.interpretText()
        model.setData(index, box.value(), Qt.ItemDataRole.EditRole)

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        font = option.font
        if index.data(CalibrationRole.DIRTY):
            font.setBold(True)
            if index.column() == 0:
                option.icon = icon("edited")
                option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration
        elif index.column() > 0 and index.data(Qt.ItemDataRole.EditRole) is None:
            font.setItalic(True)
        option.font = font


class CalibrationEditor(QWidget):
    """A table of ten channels, and buttons for the selected ones."""

    def __init__(self, draft: SettingsDraft, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("editorCalibrationPage")
        self._table = CalibrationTable(draft, self)

        about = label(
            self,
            text=self.tr(
                "A board keeps two calibrations for each channel: one for RC pulses, one for "
                "analog voltages. Calibrations that are not in the file stay as they are on the "
                "board. The count stored in the file is in brackets."
            ),
            wrap=True,
        )
        self._view = flat_table(QTableView(self), "calibrationsView", self.tr("Calibrations"))
        self._view.setModel(self._table)
        self._view.setItemDelegate(_Delegate(self))
        self._view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        triggers = QAbstractItemView.EditTrigger
        self._view.setEditTriggers(
            triggers.DoubleClicked | triggers.EditKeyPressed | triggers.AnyKeyPressed
        )
        header = self._view.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setMinimumSectionSize(17 * self.fontMetrics().averageCharWidth())
        self._note = named(Note(2, self), "calibrationsNote")
        self._add = button(
            self,
            "addCalibrationButton",
            self.tr("&Add selected"),
            tip=self.tr("Add the default calibration for the selected channels"),
            on_click=lambda: self._table.add(self._selected()),
        )
        self._leave_out = button(
            self,
            "leaveOutCalibrationButton",
            self.tr("&Leave out selected"),
            icon="clear",
            tip=self.tr("Remove the calibrations of the selected channels from the file"),
            on_click=lambda: self._table.leave_out(self._selected()),
        )
        below = row((self._note, 1), self._add, self._leave_out)
        column(about, (self._view, 1), below, into=self)

        self._table.rejected.connect(self.show_problem)
        self._table.dataChanged.connect(self._on_changed)
        self._view.selectionModel().selectionChanged.connect(self._update_buttons)
        self._on_changed()

    @Slot(str)
    def show_problem(self, text: str) -> None:
        """Show why an edit was rejected."""
        self._note.show_note(text, alarming=True)

    def _selected(self) -> tuple[CalibrationKey, ...]:
        rows = {index.row(): index for index in self._view.selectionModel().selectedIndexes()}
        return tuple(CalibrationKey(rows[row].data(CalibrationRole.KEY)) for row in sorted(rows))

    @Slot()
    def _on_changed(self) -> None:
        self._note.show_note(
            self.tr("Double-click a value to change it; type 1500, 1.5 ms, 2.5 V or 3750 counts.")
        )
        self._update_buttons()

    @Slot()
    def _update_buttons(self) -> None:
        given = [self._table.is_given(key) for key in self._selected()]
        self._add.setEnabled(not all(given))
        self._leave_out.setEnabled(any(given))
