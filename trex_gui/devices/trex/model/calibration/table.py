"""Every calibration that a settings file can give, as a table: two input sources, five channels."""

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
        rejected: why an edit was not taken, for the user.
    """

    rejected = Signal(str)

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._draft = draft
        self._calibrations = draft.calibrations
        self._calibrations.changed.connect(self._on_changed)

    # --- User actions -----------------------------------------------------------------

    def add(self, keys: Collection[CalibrationKey]) -> None:
        """Give the channels that have no calibration the usual one; one step to undo."""
        missing = [key for key in keys if not self.is_given(key)]
        if missing:
            with self._draft.one_edit(self.tr("Add calibrations")):
                for key in missing:
                    self._calibrations.edit(key, DEFAULT_CALIBRATION[key.source])

    def leave_out(self, keys: Collection[CalibrationKey]) -> None:
        """Give no calibration for these channels; one step to undo."""
        with self._draft.one_edit(self.tr("Leave out calibrations")):
            for key in keys:
                self._calibrations.leave_out(key)

    def is_given(self, key: CalibrationKey) -> bool:
        """Whether there is a calibration for this channel."""
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
        titles = (
            self.tr("Channel"),
            self.tr("Minimum"),
            self.tr("Neutral"),
            self.tr("Maximum"),
            self.tr("Deadband"),
        )
        return titles[section] if section < len(titles) else None

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
                return self._count(key, index.column())
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

    # --- Text ---------------------------------------------------------------------------

    def _text(self, key: CalibrationKey, column: int) -> str:
        if column == 0:
            name = key.source.value
            return self.tr("{0} channel {1}").format(name[0].upper() + name[1:], key.channel)
        count = self._count(key, column)
        if count is None:
            return self.tr("not given")
        return self.tr("{0} ({1})").format(key.source.text(count), count)

    def _count(self, key: CalibrationKey, column: int) -> int | None:
        shown = self._calibrations.shown(key)
        if shown is None or column == 0:
            return None
        count: int = getattr(shown, CALIBRATION_FIELDS[column - 1])
        return count

    def _is_dirty(self, key: CalibrationKey, column: int) -> bool:
        shown = self._calibrations.shown(key)
        stored = self._calibrations.stored(key)
        if column == 0 or shown is None or stored is None:
            return shown != stored
        field = CALIBRATION_FIELDS[column - 1]
        return bool(getattr(shown, field) != getattr(stored, field))
