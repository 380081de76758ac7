"""The calibrations of a settings file."""

from collections.abc import Collection
from dataclasses import replace
from typing import Any, cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractTableModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QFont
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.channel_text import input_text
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.views.count_editor import CountEditor, UnitDelegate
from trex_gui.devices.trex.views.note_field import NoteField
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets.builders import button, column, flat_table, label, named, row
from trex_gui.ui.widgets.labels import Note

Index = QModelIndex | QPersistentModelIndex
_KEYS = tuple(CalibrationKey)


class CalibrationTable(QAbstractTableModel):
    """One row per channel: its name and four counts; edits are bold, missing values italic."""

    rejected = Signal(str)  # why an edit was rejected, for the user

    def __init__(self, draft: SettingsDraft, parent: QWidget) -> None:
        super().__init__(parent)
        self._draft = draft
        self._calibrations = draft.calibrations
        fields = tr("Minimum"), tr("Neutral"), tr("Maximum"), tr("Deadband")
        self._titles = tr("Channel"), *fields
        self._calibrations.changed.connect(self._on_changed)

    def add(self, keys: Collection[CalibrationKey]) -> None:
        """Add the default calibration of channels that have none, in one undo step."""
        missing = [key for key in keys if not self.is_given(key)]
        if missing:
            with self._draft.one_edit(tr("Add calibrations")):
                for key in missing:
                    self._calibrations.edit(key, DEFAULT_CALIBRATION[key.source])

    def leave_out(self, keys: Collection[CalibrationKey]) -> None:
        """Remove the calibrations of these channels, in one undo step."""
        with self._draft.one_edit(tr("Leave out calibrations")):
            for key in keys:
                self._calibrations.leave_out(key)

    def is_given(self, key: CalibrationKey) -> bool:
        return self._calibrations.shown(key) is not None

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(_KEYS)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else 1 + len(CALIBRATION_FIELDS)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        return self._titles[section] if section < len(self._titles) else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        is_count = index.isValid() and index.column() > 0
        if is_count and self.is_given(_KEYS[index.row()]):
            flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        key = _KEYS[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._text(key, index.column())
            case Qt.ItemDataRole.EditRole:
                return _field(self._calibrations.shown(key), index.column())
            case Qt.ItemDataRole.FontRole:
                return self._font(key, index.column())
            case Qt.ItemDataRole.DecorationRole if index.column() == 0 and self._is_dirty(key, 0):
                return icon("edited")
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or not index.isValid() or index.column() == 0:
            return False
        key = _KEYS[index.row()]
        before = self._calibrations.shown(key)
        if before is None:
            return False
        wanted = replace(before, **{CALIBRATION_FIELDS[index.column() - 1]: int(value)})
        try:
            self._calibrations.edit(key, wanted)
        except BadRequest:
            text = tr("{0}: {1}. The order is minimum, neutral, maximum.")
            self.rejected.emit(text.format(key.label, wanted.problem() or ""))
            return False
        return True

    @Slot()
    def _on_changed(self) -> None:
        last = self.index(self.rowCount() - 1, self.columnCount() - 1)
        self.dataChanged.emit(self.index(0, 0), last)

    def _text(self, key: CalibrationKey, column: int) -> str:
        if column == 0:
            return key.label[:1].upper() + key.label[1:]
        count = _field(self._calibrations.shown(key), column)
        return tr("not given") if count is None else input_text(key.source, count)

    def _font(self, key: CalibrationKey, column: int) -> QFont:
        font = QFont()
        font.setBold(self._is_dirty(key, column))
        font.setItalic(column > 0 and not font.bold() and not self.is_given(key))
        return font

    def _is_dirty(self, key: CalibrationKey, column: int) -> bool:
        shown, stored = self._calibrations.shown(key), self._calibrations.stored(key)
        if column == 0:
            return shown != stored
        return _field(shown, column) != _field(stored, column)


def _field(calibration: Calibration | None, column: int) -> int | None:
    """Return the count in a column; `None` in the first, and without a calibration."""
    if calibration is None or column == 0:
        return None
    count: int = getattr(calibration, CALIBRATION_FIELDS[column - 1])
    return count


class _Delegate(UnitDelegate):
    """Edits counts in the units that the cells show."""

    def __init__(self, page: "CalibrationEditor") -> None:
        super().__init__(page)
        self._page = page

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        del option
        editor = CountEditor(_KEYS[index.row()].source, parent)
        editor.setObjectName("countEditor")
        editor.rejected.connect(self._page.show_problem)
        return editor

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        cast("CountEditor", editor).interpretText()
        super().setModelData(editor, model, index)


class CalibrationEditor(QWidget):
    """A table of ten channels, and buttons for the selected ones."""

    def __init__(self, draft: SettingsDraft, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("editorCalibrationPage")
        self._table = CalibrationTable(draft, self)

        text = tr(
            "A board keeps two calibrations for each channel: one for RC pulses, one for "
            "analog voltages. Calibrations that are not in the file stay as they are on the "
            "board. The number without a unit is the count in the file."
        )
        about = label(self, text=text, wrap=True)
        self._view = flat_table(QTableView(self), "calibrationsView", tr("Calibrations"))
        self._view.setModel(self._table)
        self._view.setItemDelegate(_Delegate(self))
        self._view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        triggers = QAbstractItemView.EditTrigger
        typed = triggers.EditKeyPressed | triggers.AnyKeyPressed
        self._view.setEditTriggers(triggers.DoubleClicked | typed)
        header = self._view.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setMinimumSectionSize(17 * self.fontMetrics().averageCharWidth())
        self._why = NoteField(draft.notes, "calibrationNoteEdit", self, lines=2)
        why = label(self, text=tr("N&ote on the calibration:"), buddy=self._why)
        self._note = named(Note(2, self), "calibrationsNote")
        text, tip = tr("&Add selected"), tr("Add the default calibration for the selected channels")
        self._add = button(self, "addCalibrationButton", text, tip=tip)
        text = tr("&Leave out selected")
        tip = tr("Remove the calibrations of the selected channels from the file")
        self._leave_out = button(self, "leaveOutCalibrationButton", text, icon="clear", tip=tip)
        below = row((self._note, 1), self._add, self._leave_out)
        column(about, (self._view, 1), row(why, (self._why, 1)), below, into=self)

        self._add.clicked.connect(lambda: self._table.add(self._selected()))
        self._leave_out.clicked.connect(lambda: self._table.leave_out(self._selected()))
        self._table.rejected.connect(self.show_problem)
        self._table.dataChanged.connect(self._on_changed)
        self._view.selectionModel().selectionChanged.connect(self._update_buttons)
        self._view.selectionModel().currentChanged.connect(self._on_current_changed)
        self._on_changed()

    @Slot(str)
    def show_problem(self, text: str) -> None:
        self._note.show_note(text, alarming=True)

    def _selected(self) -> tuple[CalibrationKey, ...]:
        rows = {index.row() for index in self._view.selectionModel().selectedIndexes()}
        return tuple(_KEYS[row] for row in sorted(rows))

    @Slot(QModelIndex)
    def _on_current_changed(self, current: QModelIndex) -> None:
        if current.isValid():
            key = _KEYS[current.row()]
            self._why.show_note_on(key, tr("the calibration of {0}").format(key.label))

    @Slot()
    def _on_changed(self) -> None:
        text = tr("Double-click a value to change it; type 1500, 1.5 ms, 2.5 V or 3750 counts.")
        self._note.show_note(text)
        self._update_buttons()

    @Slot()
    def _update_buttons(self) -> None:
        given = [self._table.is_given(key) for key in self._selected()]
        self._add.setEnabled(not all(given))
        self._leave_out.setEnabled(any(given))
