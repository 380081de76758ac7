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
from trex_gui.devices.trex.model.calibration.calibrations import Place
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.settings.document import CALIBRATION_FIELDS, CALIBRATION_KEYS

Index = QModelIndex | QPersistentModelIndex
PLACES: tuple[Place, ...] = tuple(CALIBRATION_KEYS.values())


class CalibrationRole(IntEnum):
    """What a cell tells besides its text."""

    PLACE = Qt.ItemDataRole.UserRole
    DIRTY = Qt.ItemDataRole.UserRole + 1


class CalibrationTable(QAbstractTableModel):
    """A row a channel; the first column names it, the others are its four counts.

    Signals:
        refused: why an edit was not taken, for people.
    """

    refused = Signal(str)

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._draft = draft
        self._calibrations = draft.calibrations
        self._calibrations.changed.connect(self._on_changed)

    # --- What a person does -------------------------------------------------------------

    def add(self, places: Collection[Place]) -> None:
        """Give the channels that have no calibration the usual one; one step to undo."""
        missing = [place for place in places if not self.is_given(place)]
        if missing:
            with self._draft.one_edit(self.tr("Add calibrations")):
                for source, channel in missing:
                    self._calibrations.edit(channel, DEFAULT_CALIBRATION[source], source)

    def leave_out(self, places: Collection[Place]) -> None:
        """Give no calibration for these channels; one step to undo."""
        with self._draft.one_edit(self.tr("Leave out calibrations")):
            for source, channel in places:
                self._calibrations.leave_out(channel, source)

    def is_given(self, place: Place) -> bool:
        """Whether there is a calibration for this channel."""
        source, channel = place
        return self._calibrations.shown(channel, source) is not None

    # --- Qt -----------------------------------------------------------------------------

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(PLACES)

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
        if index.column() > 0 and self.is_given(PLACES[index.row()]):
            flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        place = PLACES[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._text(place, index.column())
            case Qt.ItemDataRole.EditRole:
                return self._count(place, index.column())
            case CalibrationRole.PLACE:
                return place
            case CalibrationRole.DIRTY:
                return self._is_dirty(place, index.column())
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or not index.isValid() or index.column() == 0:
            return False
        source, channel = PLACES[index.row()]
        before = self._calibrations.shown(channel, source)
        if before is None:
            return False
        wanted = replace(before, **{CALIBRATION_FIELDS[index.column() - 1]: int(value)})
        try:
            self._calibrations.edit(channel, wanted, source)
        except BadRequest:
            problem = wanted.problem() or ""
            words = self.tr("{0} channel {1}: {2}. The order is minimum, neutral, maximum.")
            self.refused.emit(words.format(source.value, channel, problem))
            return False
        return True

    @Slot()
    def _on_changed(self) -> None:
        last = self.index(self.rowCount() - 1, self.columnCount() - 1)
        self.dataChanged.emit(self.index(0, 0), last)

    # --- Text ---------------------------------------------------------------------------

    def _text(self, place: Place, column: int) -> str:
        source, channel = place
        if column == 0:
            name = source.value
            return self.tr("{0} channel {1}").format(name[0].upper() + name[1:], channel)
        count = self._count(place, column)
        if count is None:
            return self.tr("not given")
        return self.tr("{0} ({1})").format(source.text(count), count)

    def _count(self, place: Place, column: int) -> int | None:
        source, channel = place
        shown = self._calibrations.shown(channel, source)
        if shown is None or column == 0:
            return None
        count: int = getattr(shown, CALIBRATION_FIELDS[column - 1])
        return count

    def _is_dirty(self, place: Place, column: int) -> bool:
        source, channel = place
        shown = self._calibrations.shown(channel, source)
        stored = self._calibrations.stored(channel, source)
        if column == 0 or shown is None or stored is None:
            return shown != stored
        field = CALIBRATION_FIELDS[column - 1]
        return bool(getattr(shown, field) != getattr(stored, field))
