"""The parameters of a board or a file with their edits, as a Qt model."""

from collections.abc import Mapping, Sequence
from enum import IntEnum
from typing import Any

from PySide6.QtCore import (
    QAbstractItemModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.parameters.draft import Draft
from trex_gui.devices.trex.model.parameters.text import ParameterColumn, ParameterText, pwm_partner
from trex_gui.devices.trex.protocol.parameters import (
    ParameterSet,
    ParameterSpec,
    motor_name,
    other_motor_key,
)
from trex_gui.ui.devices.undo import Edit
from trex_gui.ui.translations import error_sentence

Index = QModelIndex | QPersistentModelIndex

_COLUMN = tuple(ParameterColumn)
_COLUMNS = len(_COLUMN)

# Made once, and looked at first: Qt asks a thousand times whenever the table is painted.
_HEADING = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled
_FIXED = _HEADING | Qt.ItemFlag.ItemNeverHasChildren
_EDITABLE = _FIXED | Qt.ItemFlag.ItemIsEditable
_LEFT_TO_THE_STYLE = frozenset(
    {
        Qt.ItemDataRole.DecorationRole,
        Qt.ItemDataRole.SizeHintRole,
        Qt.ItemDataRole.FontRole,
        Qt.ItemDataRole.BackgroundRole,
        Qt.ItemDataRole.ForegroundRole,
        Qt.ItemDataRole.CheckStateRole,
    }
)


class Role(IntEnum):
    """Data of a cell besides its text; a heading has GROUP only.

    WAITING is the wire value that stays active until the next power cycle, RESET the effect of
    a reset to the default; both are `None` where nothing differs.
    """

    SPEC = Qt.ItemDataRole.UserRole
    DIRTY = Qt.ItemDataRole.UserRole + 1
    WAITING = Qt.ItemDataRole.UserRole + 2
    PROBLEM = Qt.ItemDataRole.UserRole + 3
    GROUP = Qt.ItemDataRole.UserRole + 4
    RESET = Qt.ItemDataRole.UserRole + 5


class ParameterModel(QAbstractItemModel):
    """Groups with a heading each, below it one row per parameter; edits go over an undo stack."""

    pending_changed = Signal(int)  # the number of edits
    rejected = Signal(str)  # why an edit was rejected, for the user

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self._undo = undo or QUndoStack(self)
        self._specs: dict[str, ParameterSpec] = {}
        self._groups: tuple[tuple[str, tuple[ParameterSpec, ...]], ...] = ()
        self._places: dict[str, tuple[int, int]] = {}
        self._draft = Draft()
        self._problems: dict[str, str] = {}
        self.text = ParameterText(self._specs, self._draft, self._problems, self)
        self.model_key = ""  # the kind of board that the rows belong to; empty before the first
        self.both_motors = False  # whether an edit for one motor is made for the other, too
        self._headers = (
            self.tr("Parameter"),
            self.tr("Value"),
            self.tr("Wire"),
            "",
            self.tr("Default"),
            self.tr("Range"),
            self.tr("Source"),
            self.tr("Takes effect"),
        )
        self._titles = {
            "motors": self.tr("Motors"),
            "channels": self.tr("Channels"),
            "serial": self.tr("Serial"),
            "system": self.tr("System"),
        }

    # --- Reports of the device ----------------------------------------------------------

    def load(
        self,
        specs: ParameterSet,
        stored: Mapping[str, int],
        unread: Mapping[str, str],
        *,
        power_cycled: bool,
        active: Mapping[str, int] | None = None,
        open_ended: bool = False,
    ) -> None:
        """Take everything that was read; edits stay if the board is of the same model.

        `active` are values known to be active, whatever is stored. `open_ended` (a file): any
        parameter may be added or left out.
        """
        pending = self.modified
        self.beginResetModel()
        self._arrange(specs.readable)
        self._draft.load(
            stored,
            keep_edits=specs.model.key == self.model_key,
            power_cycled=power_cycled,
            optional=self._specs if open_ended else (),
        )
        for key, wire in (active or {}).items():
            self._draft.note_active(key, wire)
        self.model_key = specs.model.key
        kept = {key: why for key, why in self._problems.items() if self.is_modified(key)}
        self._problems.clear()
        self._problems.update(kept | dict(unread))
        self.endResetModel()
        if pending != self.modified:
            self._announce_pending()

    def _arrange(self, specs: Sequence[ParameterSpec]) -> None:
        """Put parameters into their groups; empty groups are left out."""
        groups = ((group, tuple(s for s in specs if s.group == group)) for group in self._titles)
        self._groups = tuple((group, members) for group, members in groups if members)
        self._specs.clear()
        self._places.clear()
        for number, (_, members) in enumerate(self._groups):
            for row, spec in enumerate(members):
                self._specs[spec.key] = spec
                self._places[spec.key] = number, row

    def note_stored(self, stored: Mapping[str, int]) -> None:
        """Take the stored values after a verified write."""
        for key, wire in stored.items():
            if key in self._specs and wire != self.stored_of(key):
                self._draft.note_stored(self._specs[key], wire)
                self._announce(key)
        self._announce_pending()

    def note_results(self, results: Sequence[WriteResult]) -> None:
        """Take the reasons of failed writes."""
        for result in results:
            if result.key in self._specs:
                self._problems.pop(result.key, None)
                if result.error is not None:
                    self._problems[result.key] = str(result.error)
                self._announce(result.key)

    # --- Values -------------------------------------------------------------------------

    @property
    def count(self) -> int:
        return len(self._specs)

    @property
    def groups(self) -> dict[str, str]:
        """The titles of the groups that have parameters, by group."""
        return {group: self._titles[group] for group, _ in self._groups}

    @property
    def pending(self) -> tuple[tuple[str, int], ...]:
        """Keys and values that Apply or Save writes."""
        return self._draft.pending

    @property
    def modified(self) -> tuple[str, ...]:
        """Keys that are edited or left out, in the order of the table."""
        return tuple(filter(self.is_modified, self._specs))

    def is_modified(self, key: str) -> bool:
        return self._draft.is_modified(key)

    @property
    def all_stored(self) -> dict[str, int]:
        """The stored wire values that were read, by key, in the order of the table."""
        return {key: w for key in self._specs if (w := self.stored_of(key)) is not None}

    @property
    def all_shown(self) -> dict[str, int]:
        """The wire values after Apply or Save, by key, in the order of the table."""
        return {key: w for key in self._specs if (w := self.value_of(key)) is not None}

    def spec_of(self, key: str) -> ParameterSpec:
        return self._specs[key]

    @property
    def waiting_for_power(self) -> tuple[str, ...]:
        """Names of the parameters whose stored value becomes active with the next power cycle."""
        return tuple(spec.name for spec in self._specs.values() if spec.key in self._draft.active)

    def value_of(self, key: str) -> int | None:
        """Return the wire value after Apply or Save; `None`: not read, or left out."""
        return self._draft.value(key)

    def stored_of(self, key: str) -> int | None:
        """Return the stored wire value; `None`: not read."""
        return self._draft.stored.get(key)

    def active_of(self, key: str) -> int | None:
        """Return the active wire value, which may differ from the stored one; `None`: not read."""
        return self._draft.active.get(key, self.stored_of(key))

    def can_edit(self, key: str) -> bool:
        """Whether a parameter can be edited: it was read, or is optional."""
        return key in self._specs and self._draft.accepts(key)

    def can_leave_out(self, key: str) -> bool:
        return key in self._draft.optional and self.value_of(key) is not None

    def other_motor_of(self, key: str) -> str | None:
        """Return the same parameter of the other motor if both can be edited."""
        other_motor = other_motor_key(key)
        if other_motor is None or not self.can_edit(key) or not self.can_edit(other_motor):
            return None
        return other_motor

    # --- Edits --------------------------------------------------------------------------

    def edit(self, key: str, wire: int, *, alone: bool = False) -> None:
        """Edit a value; the stored value drops the edit.

        With `both_motors`, the other motor gets the value in the same step, except with `alone`.

        Raises:
            BadRequest: the value is outside the parameter's limits.
            KeyError: the parameter does not exist, or was not read.
        """
        if not self.can_edit(key):
            raise KeyError(key)
        if wire == self.value_of(key):
            return  # an editor that was opened and left does not edit the other motor either
        keys = (key,) if alone else self._with_other_motor(key)
        for each in keys:
            if wire != self.stored_of(each):
                self._specs[each].check(wire)
        self._change(dict.fromkeys(keys, wire))

    def reset(self, key: str) -> None:
        if self.can_edit(key):
            self.edit(key, self._specs[key].default)

    def restore(self, key: str) -> None:
        """Go back to the stored value; with `both_motors`, each to its own."""
        if self.can_edit(key):
            self._change({each: self.stored_of(each) for each in self._with_other_motor(key)})

    def leave_out(self, key: str) -> None:
        if self.can_leave_out(key):
            keys = filter(self.can_leave_out, self._with_other_motor(key))
            self._change(dict.fromkeys(keys))

    def copy_to_other_motor(self, key: str) -> None:
        other_motor, wire = self.other_motor_of(key), self.value_of(key)
        if other_motor is not None and wire is not None:
            self._change({other_motor: wire})

    def discard_edits(self) -> None:
        """Go back to the stored values, one undo step for each."""
        for key in self.modified:
            self._change({key: self.stored_of(key)})

    def _with_other_motor(self, key: str) -> tuple[str, ...]:
        other_motor = self.other_motor_of(key) if self.both_motors else None
        return (key,) if other_motor is None else (key, other_motor)

    def _change(self, wanted: Mapping[str, int | None]) -> None:
        """Push edits of the values that differ; two motors' edits are one undo step."""
        edits = [
            Edit(self._specs[key].name, self._put, key, before, wire)
            for key, wire in wanted.items()
            if wire != (before := self.value_of(key))
        ]
        if len(edits) > 1:
            key = next(iter(wanted))
            name = self._specs[key].name.removeprefix(motor_name(key))
            self._undo.beginMacro(self.tr("Motors 1 and 2{0}").format(name))
        for each in edits:
            self._undo.push(each)
        if len(edits) > 1:
            self._undo.endMacro()

    def _put(self, key: str, wire: int | None) -> None:
        """Apply an edit to the draft; ignores parameters that the present board lacks."""
        if self.can_edit(key):
            if wire is None:
                self._draft.leave_out(key)
            else:
                self._draft.edit(self._specs[key], wire)
            self._announce(key)
            self._announce_pending()

    # --- Qt -----------------------------------------------------------------------------

    def index_of(self, key: str, column: ParameterColumn = ParameterColumn.VALUE) -> QModelIndex:
        """Return the cell of a parameter, invalid when there is none."""
        place = self._places.get(key)
        return QModelIndex() if place is None else self._cell(*place, column)

    def index_of_group(self, group: str) -> QModelIndex:
        """Return the heading of a group, invalid when there is none."""
        groups = list(self.groups)
        return self.index(groups.index(group), 0) if group in groups else QModelIndex()

    def _cell(self, group: int, row: int, column: int) -> QModelIndex:
        return self.createIndex(row, column, group + 1)  # a heading has 0

    def _spec_at(self, index: Index) -> ParameterSpec | None:
        """Return the parameter of a cell; `None` for a heading or an invalid index."""
        group = index.internalId() if index.isValid() else 0
        return self._groups[group - 1][1][index.row()] if group else None

    def index(self, row: int, column: int, parent: Index | None = None) -> QModelIndex:
        if not (0 <= row < self.rowCount(parent) and 0 <= column < _COLUMNS):
            return QModelIndex()
        return self._cell(-1 if parent is None else parent.row(), row, column)

    def parent(self, index: Index | None = None) -> Any:
        if index is None:
            return super().parent()
        group = index.internalId() if index.isValid() else 0
        return self.createIndex(group - 1, 0, 0) if group else QModelIndex()

    def rowCount(self, parent: Index | None = None) -> int:
        if parent is None or not parent.isValid():
            return len(self._groups)
        if parent.internalId() or parent.column() > 0:
            return 0
        return len(self._groups[parent.row()][1])

    def columnCount(self, _parent: Index | None = None) -> int:
        return _COLUMNS

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or section >= _COLUMNS:
            return None
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._headers[section]
            case Qt.ItemDataRole.TextAlignmentRole if section == ParameterColumn.WIRE:
                return int(Qt.AlignmentFlag.AlignCenter)
            case Qt.ItemDataRole.AccessibleTextRole if section == ParameterColumn.RESET:
                return self.tr("Reset to default")
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        spec = self._spec_at(index)
        if spec is None:
            return _HEADING
        is_editable = index.column() == ParameterColumn.VALUE and self.can_edit(spec.key)
        return _EDITABLE if is_editable else _FIXED

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role in _LEFT_TO_THE_STYLE or not index.isValid():
            return None
        spec = self._spec_at(index)
        if spec is None:
            return self._heading_data(index.row(), index.column(), role)
        column = _COLUMN[index.column()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self.text.cell(spec, column)
            case Qt.ItemDataRole.EditRole:
                return self.value_of(spec.key)
            case Qt.ItemDataRole.ToolTipRole if column is not ParameterColumn.RESET:
                return self.text.tool_tip(spec, column)
            case Qt.ItemDataRole.TextAlignmentRole if column is ParameterColumn.WIRE:
                return int(Qt.AlignmentFlag.AlignCenter)
            case Role.SPEC:
                return spec
            case Role.DIRTY:
                return self.is_modified(spec.key)
            case Role.WAITING:
                return self._draft.active.get(spec.key)
            case Role.PROBLEM:
                return self._problems.get(spec.key)
            case Role.RESET:
                differs = self.value_of(spec.key) not in {None, spec.default}
                return self.text.reset(spec) if differs else None
            case Qt.ItemDataRole.ToolTipRole | Qt.ItemDataRole.AccessibleTextRole if (
                column is ParameterColumn.RESET
            ):
                return self.data(index, Role.RESET)
        return None

    def _heading_data(self, row: int, column: int, role: int) -> Any:
        group, members = self._groups[row]
        if role == Role.GROUP:
            return group
        if role != Qt.ItemDataRole.DisplayRole or column > 0:
            return None
        title, modified = self._titles[group], sum(self.is_modified(spec.key) for spec in members)
        if modified:
            return self.tr("{0} ({1}, {2} modified)").format(title, len(members), modified)
        return self.tr("{0} ({1})").format(title, len(members))

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        spec = self._spec_at(index)
        if spec is None or role != Qt.ItemDataRole.EditRole:
            return False
        if not self.flags(index) & Qt.ItemFlag.ItemIsEditable:
            return False
        try:
            self.edit(spec.key, int(value))
        except BadRequest as error:
            self.rejected.emit(error_sentence(error))
            return False
        except (TypeError, ValueError, OverflowError):
            self.rejected.emit(f"{spec.name} is {spec.range_text()}, not {value}.")
            return False
        return True

    # --- Change notification ------------------------------------------------------------

    def _announce_pending(self) -> None:
        self.pending_changed.emit(len(self.modified))

    def _announce(self, key: str) -> None:
        """Announce a row, the rows whose text refers to it, and its group's heading."""
        other_motor = other_motor_key(key)
        for each in (key, other_motor, pwm_partner(key), pwm_partner(other_motor or "")):
            if each in self._places:
                group, row = self._places[each]
                self.dataChanged.emit(
                    self._cell(group, row, 0), self._cell(group, row, _COLUMNS - 1)
                )
        heading = self.index(self._places[key][0], 0)
        self.dataChanged.emit(heading, heading)
