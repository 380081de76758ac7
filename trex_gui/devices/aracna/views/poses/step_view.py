"""The steps of a sequence: a table with a list of poses and a time in each row."""

from typing import Any

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QPersistentModelIndex, Qt, Slot
from PySide6.QtGui import QKeyEvent, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHeaderView,
    QSpinBox,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.step_table import StepColumn, StepTable
from trex_gui.devices.aracna.poses.sequence import LONGEST_MS, SHORTEST_MS, can_be_named
from trex_gui.devices.aracna.views.poses.name_list import paint_empty
from trex_gui.ui.widgets.header_names import name_headers
from trex_gui.ui.widgets.no_wheel_combo_box import NoWheelComboBox

_Index = QModelIndex | QPersistentModelIndex
_LINES = 5


class _Delegate(QStyledItemDelegate):
    """Edits a pose by a list of those that there are, a time in milliseconds."""

    def __init__(self, library: Library, parent: QWidget) -> None:
        super().__init__(parent)
        self._library = library

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: _Index) -> QWidget:
        del option
        if index.column() == StepColumn.POSE:
            combo = NoWheelComboBox(parent)
            combo.setObjectName("aracnaStepPose")
            combo.setAccessibleName(self.tr("Pose of step {0}").format(index.row() + 1))
            names = [pose.name for pose in self._library.poses]
            combo.addItems([name for name in names if can_be_named(name)])
            if combo.findText(str(index.data())) < 0:  # one that is not defined stays possible
                combo.insertItem(0, str(index.data()))
            combo.activated.connect(self._on_activated)
            return combo
        spin = QSpinBox(parent)
        spin.setObjectName("aracnaStepTime")
        spin.setAccessibleName(self.tr("Milliseconds of step {0}").format(index.row() + 1))
        spin.setRange(SHORTEST_MS, LONGEST_MS)
        spin.setSingleStep(100)
        spin.setSuffix(self.tr(" ms"))
        return spin

    def setEditorData(self, editor: QWidget, index: _Index) -> None:
        value: Any = index.data(Qt.ItemDataRole.EditRole)
        if isinstance(editor, QComboBox):
            editor.setCurrentIndex(editor.findText(str(value)))
        elif isinstance(editor, QSpinBox):
            editor.setValue(int(value))

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: _Index) -> None:
        if isinstance(editor, QComboBox):
            model.setData(index, editor.currentText())
        elif isinstance(editor, QSpinBox):
            editor.interpretText()
            model.setData(index, editor.value())

    @Slot()
    def _on_activated(self) -> None:
        """Take a pose as soon as it is chosen."""
        editor = self.sender()
        if isinstance(editor, QWidget):
            self.commitData.emit(editor)


class StepView(QTableView):
    """Shows a step table. Delete removes a step, Alt with up and down moves it."""

    def __init__(self, table: StepTable, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = table
        self.setObjectName("aracnaSteps")
        self.setAccessibleName(self.tr("Steps"))
        self.setModel(table)
        self.setItemDelegate(_Delegate(library, self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.SelectedClicked
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 8)
        head = self.horizontalHeader()
        head.setHighlightSections(False)
        head.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        head.setSectionResizeMode(StepColumn.NOTE, QHeaderView.ResizeMode.Stretch)
        head.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        name_headers(self)
        self.setMinimumHeight(_LINES * (self.fontMetrics().height() + 8))

    @property
    def row(self) -> int:
        """The row that is chosen; -1 for none."""
        return self.currentIndex().row()

    def choose(self, row: int) -> None:
        """Choose a row; one beyond the end is the last."""
        row = min(row, self._table.rowCount() - 1)
        if row >= 0:
            column = max(self.currentIndex().column(), int(StepColumn.POSE))
            self.setCurrentIndex(self._table.index(row, column))

    def shift(self, by: int) -> None:
        """Move the chosen step up (-1) or down (1)."""
        row = self.row
        if self._table.move(row, row + by):
            self.choose(row + by)

    def remove(self) -> None:
        """Take the chosen step away."""
        row = self.row
        if row >= 0 and self._table.editable:
            self._table.remove(row)
            self.choose(row)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        by = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}.get(Qt.Key(event.key()))
        if event.key() == Qt.Key.Key_Delete:
            self.remove()
        elif by is not None and event.modifiers() & Qt.KeyboardModifier.AltModifier:
            self.shift(by)
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._table.rowCount() == 0:
            text = self.tr("Choose a sequence or a gait to see its steps.")
            if self._table.editable:
                text = self.tr("No steps yet. Add one: it takes the pose that is chosen.")
            paint_empty(self, text)
