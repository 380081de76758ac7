"""Two sets of settings as a table, with a check box for each change."""

from collections.abc import Mapping
from enum import IntEnum
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)

from trex_gui.devices.trex.model.settings.rows import renew_rows
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    CALIBRATION_KEYS,
    Calibration,
)
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow

Index = QModelIndex | QPersistentModelIndex


class ComparisonColumn(IntEnum):
    """The columns, left to right; the last is there once something was tried."""

    SETTING = 0
    BEFORE = 1
    AFTER = 2
    WIRE = 3
    OUTCOME = 4


class ComparisonRole(IntEnum):
    """Data of a cell besides its text."""

    CHANGED = Qt.ItemDataRole.UserRole
    KEY = Qt.ItemDataRole.UserRole + 1
    FAILED = Qt.ItemDataRole.UserRole + 2
    STORED = Qt.ItemDataRole.UserRole + 3


class ComparisonTable(QAbstractTableModel):
    """One row a setting; the rows that differ, or all.

    Signals:
        ticked_changed: other rows are ticked.
    """

    ticked_changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._comparison = Comparison(())
        self._rows: list[ComparisonRow] = []
        self._ticked: set[str] = set()
        self._unticked: set[str] = set()
        self._with_ticks = True
        self._with_equal = False
        self._outcomes: dict[str, str] = {}
        self._titles = (self.tr("Before"), self.tr("After"))

    # --- What is shown ------------------------------------------------------------------

    def show_comparison(
        self, comparison: Comparison, before: str, after: str, *, with_ticks: bool = True
    ) -> None:
        """Show another comparison, every change ticked; the texts head the two columns."""
        self.beginResetModel()
        self._comparison = comparison
        self._titles = (before, after)
        self._with_ticks = with_ticks
        self._ticked = {row.key for row in comparison.rows if row.changed} if with_ticks else set()
        self._unticked = set()
        self._outcomes = {}
        self._rows = self._chosen_rows()
        self.endResetModel()
        self.ticked_changed.emit()

    def renew(self, comparison: Comparison, *, tick_new: bool = True) -> None:
        """Update both sides; cleared check boxes stay cleared.

        Other changes are ticked; without `tick_new` only those that were there.
        """
        before = {row.key for row in self._comparison.rows if row.changed}
        changed = {row.key for row in comparison.rows if row.changed}
        self._comparison = comparison
        self.set_outcomes({})
        if self._with_ticks:
            self._unticked |= before - self._ticked
            self._ticked = changed - self._unticked if tick_new else changed & self._ticked
        renew_rows(self, self._rows, self._chosen_rows(), lambda row: row.key)
        self._announce_ticks()

    def set_with_equal(self, with_equal: bool) -> None:
        """Show the rows whose two sides match, too."""
        self._with_equal = with_equal
        renew_rows(self, self._rows, self._chosen_rows(), lambda row: row.key)

    def _chosen_rows(self) -> list[ComparisonRow]:
        return list(self._comparison.rows if self._with_equal else self._comparison.differing)

    @property
    def comparison(self) -> Comparison:
        """What is compared, whatever part of it is shown."""
        return self._comparison

    # --- Ticks --------------------------------------------------------------------------

    @property
    def ticked(self) -> tuple[ComparisonRow, ...]:
        """The changes that are wanted, in the order of the table."""
        return tuple(row for row in self._comparison.rows if row.key in self._ticked)

    def tick_all(self, ticked: bool) -> None:
        """Want every change, or none."""
        changed = {row.key for row in self._comparison.rows if row.changed}
        self._set_ticked(changed if ticked and self._with_ticks else set())

    def freeze(self, before: str, after: str) -> None:
        """Keep only the checked rows, under new headings, with the check boxes fixed."""
        rows = self.ticked
        self.beginResetModel()
        self._titles = (before, after)
        self._comparison = Comparison(rows, self._comparison.left_out)
        self._with_ticks = False
        self._rows = self._chosen_rows()
        self.endResetModel()

    def toggle(self, row: int) -> None:
        """Want the change of a row that was not wanted, or the other way round."""
        index = self.index(row, ComparisonColumn.SETTING)
        if self._is_tickable(index):
            ticked = self._rows[row].key in self._ticked
            wanted = Qt.CheckState.Unchecked if ticked else Qt.CheckState.Checked
            self.setData(index, wanted, Qt.ItemDataRole.CheckStateRole)

    def _set_ticked(self, ticked: set[str]) -> None:
        self._ticked = ticked
        self._unticked = set()
        self._announce_ticks()

    def _announce_ticks(self) -> None:
        if self._rows:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self._rows) - 1, 0))
        self.ticked_changed.emit()

    # --- How it went --------------------------------------------------------------------

    def set_outcomes(self, outcomes: Mapping[str, str]) -> None:
        """Say how writing went, by key: empty where it is stored, else why it is not."""
        place, nowhere = ComparisonColumn.OUTCOME, QModelIndex()
        if outcomes and not self._outcomes:
            self.beginInsertColumns(nowhere, place, place)
            self._outcomes = dict(outcomes)
            self.endInsertColumns()
        elif self._outcomes and not outcomes:
            self.beginRemoveColumns(nowhere, place, place)
            self._outcomes = {}
            self.endRemoveColumns()
        else:
            self._outcomes = dict(outcomes)
        if outcomes and self._rows:
            last = self.index(len(self._rows) - 1, self.columnCount() - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    # --- Qt -----------------------------------------------------------------------------

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index | None = None) -> int:
        if parent is not None and parent.isValid():
            return 0
        return len(ComparisonColumn) if self._outcomes else len(ComparisonColumn) - 1

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        titles = (self.tr("Setting"), *self._titles, self.tr("Wire"), self.tr("Result"))
        return titles[section] if section < self.columnCount() else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        flags = (
            Qt.ItemFlag.ItemIsEnabled
            | Qt.ItemFlag.ItemIsSelectable
            | Qt.ItemFlag.ItemNeverHasChildren
        )
        if self._is_tickable(index):
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        row = self._rows[index.row()]
        column = ComparisonColumn(index.column())
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._text(row, column)
            case Qt.ItemDataRole.ToolTipRole:
                return self._text(row, column) or None
            case Qt.ItemDataRole.CheckStateRole if self._is_tickable(index):
                ticked = row.key in self._ticked
                return Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked
            case ComparisonRole.CHANGED:
                return row.before != row.after
            case ComparisonRole.KEY:
                return row.key
            case ComparisonRole.FAILED:
                return bool(self._outcomes.get(row.key))
            case ComparisonRole.STORED:
                return self._outcomes.get(row.key) == ""
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.CheckStateRole or not self._is_tickable(index):
            return False
        key = self._rows[index.row()].key
        if Qt.CheckState(value) is Qt.CheckState.Checked:
            self._ticked.add(key)
            self._unticked.discard(key)
        else:
            self._ticked.discard(key)
        self.dataChanged.emit(index, index)
        self.ticked_changed.emit()
        return True

    def _is_tickable(self, index: Index) -> bool:
        return (
            self._with_ticks
            and index.isValid()
            and index.column() == ComparisonColumn.SETTING
            and self._rows[index.row()].changed
        )

    # --- Text ---------------------------------------------------------------------------

    def _text(self, row: ComparisonRow, column: ComparisonColumn) -> str:
        match column:
            case ComparisonColumn.SETTING:
                return row.name
            case ComparisonColumn.BEFORE:
                return self._side(row, row.before, row.after, row.text_before)
            case ComparisonColumn.AFTER:
                return self._side(row, row.after, row.before, row.text_after)
            case ComparisonColumn.WIRE:
                return _wires(row)
            case ComparisonColumn.OUTCOME:
                outcome = self._outcomes.get(row.key)
                return "" if outcome is None else outcome or self.tr("stored")

    def _side(
        self,
        row: ComparisonRow,
        value: int | Calibration | None,
        other: int | Calibration | None,
        text: str,
    ) -> str:
        """One side in physical units; of a calibration each field that differs, on its line."""
        if value is None:
            return self.tr("not given")
        differing = _differing(value, other)
        if not isinstance(value, Calibration) or not differing:
            return text
        source = CALIBRATION_KEYS[row.key].source
        return "\n".join(f"{name} {source.text(getattr(value, name))}" for name in differing)


def _differing(value: int | Calibration | None, other: int | Calibration | None) -> tuple[str, ...]:
    """Return the fields in which two calibrations differ: all, where one is not known."""
    if not isinstance(value, Calibration) and not isinstance(other, Calibration):
        return ()
    return tuple(f for f in CALIBRATION_FIELDS if _field(value, f) != _field(other, f))


def _field(value: int | Calibration | None, name: str) -> int | None:
    return getattr(value, name) if isinstance(value, Calibration) else None


def _wires(row: ComparisonRow) -> str:
    before, after = row.before, row.after
    if before == after:
        return _wire(before)
    if differing := _differing(before, after):
        pairs = ((_wire(_field(before, f)), _wire(_field(after, f))) for f in differing)
        return "\n".join(f"{left} → {right}" for left, right in pairs)
    return f"{_wire(before)} → {_wire(after)}"


def _wire(value: int | Calibration | None) -> str:
    if isinstance(value, Calibration):
        return " ".join(str(getattr(value, name)) for name in CALIBRATION_FIELDS)
    return "–" if value is None else str(value)
