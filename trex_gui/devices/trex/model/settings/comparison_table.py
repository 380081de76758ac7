"""Table of changes with check boxes."""

from collections.abc import Callable, Collection, Hashable, Mapping, Sequence
from enum import IntEnum
from types import MappingProxyType
from typing import Any, TypeVar

from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QFont

from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration
from trex_gui.devices.trex.settings.comparison import (
    Comparison,
    ComparisonRow,
    text_of_notes,
    wire_text,
)
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import plain

Index = QModelIndex | QPersistentModelIndex
RowT = TypeVar("RowT")

_NONE = "–"


class ComparisonColumn(IntEnum):
    """Columns of the table. OUTCOME exists only after a write.

    The user role returns the key of the row.
    """

    SETTING = 0
    BEFORE = 1
    AFTER = 2
    WIRE = 3
    OUTCOME = 4


class ComparisonTable(QAbstractTableModel):
    ticked_changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.comparison = Comparison(())
        self._rows: list[ComparisonRow] = []
        self._cleared: set[str] = set()  # keys of rows whose check box is cleared
        self._with_ticks = True
        self._with_equal = False
        self._outcomes: dict[str, str] = {}
        self._titles = ("", "")

    def show_comparison(
        self,
        comparison: Comparison,
        before: str,
        after: str,
        *,
        with_ticks: bool = True,
        outcomes: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        """Show a comparison with every change ticked.

        `before` and `after` are column titles. `outcomes`: key → reason for the failure, empty
        for a stored value.
        """
        self.beginResetModel()
        self.comparison = comparison
        self._titles = (before, after)
        self._with_ticks = with_ticks
        self._cleared = set()
        self._outcomes = dict(outcomes)
        self._rows = self._visible_rows()
        self.endResetModel()
        self.ticked_changed.emit()

    def renew(self, comparison: Comparison, *, tick_new: bool = True) -> None:
        """Update both sides. Cleared check boxes stay cleared.

        New changes are ticked only with `tick_new`.
        """
        if not tick_new:
            ticked = {row.key for row in self.ticked}
            self._cleared |= {row.key for row in comparison.rows if row.is_offered} - ticked
        self.comparison = comparison
        renew_rows(self, self._rows, self._visible_rows(), lambda row: row.key)
        self._emit_ticked_changed()

    def set_with_equal(self, with_equal: bool) -> None:
        self._with_equal = with_equal
        renew_rows(self, self._rows, self._visible_rows(), lambda row: row.key)

    def _visible_rows(self) -> list[ComparisonRow]:
        return list(self.comparison.rows if self._with_equal else self.comparison.differing)

    @property
    def ticked(self) -> tuple[ComparisonRow, ...]:
        return self.ticked_of(self.comparison)

    def ticked_of(self, comparison: Comparison) -> tuple[ComparisonRow, ...]:
        rows = comparison.rows if self._with_ticks else ()
        return tuple(row for row in rows if row.is_offered and row.key not in self._cleared)

    def tick_all(self, ticked: bool) -> None:
        offered = {row.key for row in self.comparison.rows if row.is_offered}
        self._cleared = set() if ticked else offered
        self._emit_ticked_changed()

    def tick(self, keys: Collection[str]) -> None:
        self._cleared -= set(keys)
        self._emit_ticked_changed()

    def toggle(self, row: int) -> None:
        index = self.index(row, ComparisonColumn.SETTING)
        is_cleared = self._rows[row].key in self._cleared
        state = Qt.CheckState.Checked if is_cleared else Qt.CheckState.Unchecked
        self.setData(index, state, Qt.ItemDataRole.CheckStateRole)

    def _emit_ticked_changed(self) -> None:
        if self._rows:
            last = self.index(len(self._rows) - 1, self.columnCount() - 1)
            self.dataChanged.emit(self.index(0, 0), last)
        self.ticked_changed.emit()

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index | None = None) -> int:
        if parent is not None and parent.isValid():
            return 0
        return len(ComparisonColumn) if self._outcomes else len(ComparisonColumn) - 1

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        titles = (tr("Setting"), *self._titles, tr("Wire"), tr("Result"))
        return titles[section] if section < self.columnCount() else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        return flags | Qt.ItemFlag.ItemIsUserCheckable if self._is_tickable(index) else flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        row = self._rows[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._cells(row)[index.column()]
            case Qt.ItemDataRole.ToolTipRole:
                return plain(self._cells(row)[index.column()])
            case Qt.ItemDataRole.CheckStateRole if self._is_tickable(index):
                is_cleared = row.key in self._cleared
                return Qt.CheckState.Unchecked if is_cleared else Qt.CheckState.Checked
            case Qt.ItemDataRole.FontRole if index.column() == ComparisonColumn.AFTER:
                font = QFont()
                font.setBold(row.before != row.after)
                return font
            case Qt.ItemDataRole.ForegroundRole if index.column() == ComparisonColumn.BEFORE:
                return theme().color("muted")
            case Qt.ItemDataRole.ForegroundRole if index.column() == ComparisonColumn.AFTER:
                return theme().color("accent") if row.before != row.after else None
            case Qt.ItemDataRole.DecorationRole if index.column() == ComparisonColumn.AFTER:
                return icon("arrow") if row.before != row.after else None
            case Qt.ItemDataRole.DecorationRole if index.column() == ComparisonColumn.OUTCOME:
                outcome = self._outcomes.get(row.key)
                return None if outcome is None else icon("warning" if outcome else "ok")
            case Qt.ItemDataRole.UserRole:
                return row.key
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.CheckStateRole or not self._is_tickable(index):
            return False
        key = self._rows[index.row()].key
        if Qt.CheckState(value) is Qt.CheckState.Checked:
            self._cleared.discard(key)
        else:
            self._cleared.add(key)
        self.dataChanged.emit(index, index)
        self.ticked_changed.emit()
        return True

    def _is_tickable(self, index: Index) -> bool:
        return (
            self._with_ticks
            and index.isValid()
            and index.column() == ComparisonColumn.SETTING
            and self._rows[index.row()].is_offered
        )

    def _cells(self, row: ComparisonRow) -> tuple[str, ...]:
        outcome = self._outcomes.get(row.key)
        note = text_of_notes(row.note_before, row.note_after)
        return (
            f"{row.name}\n{tr('Note: {0}').format(note)}" if note else row.name,
            self._side_text(row, row.before, row.text_before),
            self._side_text(row, row.after, row.text_after),
            _wires_text(row),
            "" if outcome is None else outcome or tr("stored"),
        )

    def _side_text(self, row: ComparisonRow, value: int | Calibration | None, text: str) -> str:
        if value is None:
            return tr("not given")
        if isinstance(value, int) or row.before == row.after:
            return text
        source = CALIBRATION_KEYS[row.key].source
        return "\n".join(f"{f} {source.text(getattr(value, f))}" for f in row.differing_fields)


def _wires_text(row: ComparisonRow) -> str:
    before, after = row.before, row.after
    if before == after:
        return wire_text(before, _NONE)
    pairs = [(getattr(before, f, None), getattr(after, f, None)) for f in row.differing_fields]
    return "\n".join(
        f"{wire_text(old, _NONE)} → {wire_text(new, _NONE)}"
        for old, new in pairs or [(before, after)]
    )


def renew_rows(
    model: QAbstractItemModel,
    rows: list[RowT],
    new_rows: Sequence[RowT],
    key: Callable[[RowT], Hashable],
) -> None:
    """Update the `rows` of a model in place.

    Selection, scroll position and check boxes are retained. `key` identifies a row. The model is
    reset if the remaining rows change their order.
    """
    if not rows and not new_rows:
        return
    keys = [key(row) for row in new_rows]
    old_keys = [key(row) for row in rows]
    remaining = set(keys) & set(old_keys)
    if not rows or [k for k in old_keys if k in remaining] != [k for k in keys if k in remaining]:
        model.beginResetModel()
        rows[:] = new_rows
        model.endResetModel()
        return
    root = QModelIndex()
    for index in reversed(range(len(rows))):
        if key(rows[index]) not in remaining:
            model.beginRemoveRows(root, index, index)
            del rows[index]
            model.endRemoveRows()
    for index, row in enumerate(new_rows):
        if index >= len(rows) or key(rows[index]) != keys[index]:
            model.beginInsertRows(root, index, index)
            rows.insert(index, row)
            model.endInsertRows()
        elif rows[index] != row:
            rows[index] = row
            last = model.index(index, model.columnCount() - 1)
            model.dataChanged.emit(model.index(index, 0), last)
