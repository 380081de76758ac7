"""Every calibration that a settings file can hold: two input sources, five channels each."""

from collections.abc import Collection
from dataclasses import replace
from enum import IntEnum
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)

Index = QModelIndex | QPersistentModelIndex
KEYS = tuple(CalibrationKey)


class CalibrationRole(IntEnum):
    """Data of a cell besides its text."""

    KEY = Qt.ItemDataRole.UserRole
    DIRTY = Qt.ItemDataRole.UserRole + 1


class CalibrationTable(QAbstractTableModel):
    """A row a channel; the first column names it, the others are its four counts.

    Signals:
        rejected: why an edit was rejected, for the user.
    """

    rejected = Signal(str)

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._draft = draft
        self._calibrations = draft.calibrations
        self._titles = (
            self.tr("Channel"),
            self.tr("Minimum"),
            self.tr("Neutral"),
            self.tr("Maximum"),
            self.tr("Deadband"),
        )
        self._calibrations.changed.connect(self._on_changed)

    # --- User actions -----------------------------------------------------------------

    def add(self, keys: Collection[CalibrationKey]) -> None:
        """Add the default calibration of channels that have none, in one undo step."""
        missing = [key for key in keys if not self.is_given(key)]
        if missing:
            with self._draft.one_edit(self.tr("Add calibrations")):
                for key in missing:
                    self._calibrations.edit(key, DEFAULT_CALIBRATION[key.source])

    def leave_out(self, keys: Collection[CalibrationKey]) -> None:
        """Remove the calibrations of these channels, in one undo step."""
        with self._draft.one_edit(self.tr("Leave out calibrations")):
            for key in keys:
                self._calibrations.leave_out(key)

    def is_given(self, key: CalibrationKey) -> bool:
        return self._calibrations.shown(key) is not None

    # --- Qt -----------------------------------------------------------------------------

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(KEYS)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else 1 + len(CALIBRATION_FIELDS)

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        return self._titles[section] if section < len(self._titles) else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        flags = (
            Qt.ItemFlag.ItemIsEnabled
            | Qt.ItemFlag.ItemIsSelectable
            | Qt.ItemFlag.ItemNeverHasChildren
        )
        if index.column() > 0 and self.is_given(KEYS[index.row()]):
            flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        key = KEYS[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._text(key, index.column())
            case Qt.ItemDataRole.EditRole:
                return _field(self._calibrations.shown(key), index.column())
            case CalibrationRole.KEY:
                return key
            case CalibrationRole.DIRTY:
                return self._is_dirty(key, index.column())
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or not index.isValid() or index.column() == 0:
            return False
        key = KEYS[index.row()]
        before = self._calibrations.shown(key)
        if before is None:
            return False
        wanted = replace(before, **{CALIBRATION_FIELDS[index.column() - 1]: int(value)})
        try:
            self._calibrations.edit(key, wanted)
        except BadRequest:
            problem = wanted.problem() or ""
            words = self.tr("{0} channel {1}: {2}. The order is minimum, neutral, maximum.")
            self.rejected.emit(words.format(key.source.value, key.channel, problem))
            return False
        return True

    @Slot()
    def _on_changed(self) -> None:
        last = self.index(self.rowCount() - 1, self.columnCount() - 1)
        self.dataChanged.emit(self.index(0, 0), last)

    # --- Cells --------------------------------------------------------------------------

    def _text(self, key: CalibrationKey, column: int) -> str:
        if column == 0:
            name = key.source.value
            return self.tr("{0} channel {1}").format(name[0].upper() + name[1:], key.channel)
        count = _field(self._calibrations.shown(key), column)
        if count is None:
            return self.tr("not given")
        return self.tr("{0} ({1})").format(key.source.text(count), count)

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
