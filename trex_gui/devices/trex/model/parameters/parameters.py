"""Qt table model of the parameters and their edits."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
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
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.parameters.text import (
    ParameterColumn,
    ParameterText,
    frequency_code,
    frequency_wires,
)
from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.parameters import ParameterSet, motor_name, other_motor_key
from trex_gui.devices.trex.settings.accepted import Accepted
from trex_gui.ui.devices.undo import Edit
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import error_sentence

Index = QModelIndex | QPersistentModelIndex

_COLUMNS = len(ParameterColumn)
_GROUPS = ("motors", "channels", "serial", "system")  # in the order of settings files

# Created once, because Qt requests flags a thousand times per paint event
_HEADING = Qt.ItemFlag.NoItemFlags  # arrow keys skip it
_FIXED = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemNeverHasChildren
_EDITABLE = _FIXED | Qt.ItemFlag.ItemIsEditable


class ParameterRole(IntEnum):
    """Data of a cell besides its text. A heading has GROUP only.

    ACTIVE is the wire value that stays active until a power cycle, or `None`. RESET is the text of
    the command that resets the value, or `None` for a value at its default. The name cell of a row
    returns the data of the row's first value.
    """

    KEY = Qt.ItemDataRole.UserRole
    DIRTY = Qt.ItemDataRole.UserRole + 1
    ACTIVE = Qt.ItemDataRole.UserRole + 2
    PROBLEM = Qt.ItemDataRole.UserRole + 3
    GROUP = Qt.ItemDataRole.UserRole + 4
    RESET = Qt.ItemDataRole.UserRole + 5


@dataclass(frozen=True, slots=True)
class ParameterRow:
    """Heading or setting.

    `keys` contains a key for each motor, or a single key. A heading has no keys.
    """

    group: str
    name: str
    keys: tuple[str, ...] = ()


def _edit_value(wires: Sequence[int]) -> int:
    return wires[0] if len(wires) == 1 else frequency_code(*wires)


class ParameterModel(QAbstractTableModel):
    """Table of settings with a column for each motor.

    Edits can be undone. The prescaler and the maximum of a PWM share a cell, which shows the
    frequency. The edit role of this cell is a `frequency_code`.
    """

    pending_changed = Signal()  # an edit, a written value or an accepted value has changed
    rejected = Signal(str)  # reason for the user
    rounded = Signal(str)  # the rounded value as text for the user

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self._undo = undo or QUndoStack(self)
        self.values = ParameterValues()
        self.text = ParameterText(self.values)
        self.rows: list[ParameterRow] = []  # grouped by task
        self._positions: dict[str, tuple[int, int]] = {}  # key → row and column
        self.model_key = ""  # empty before `load`
        self.both_motors = False  # an edit for one motor applies to both
        self._headers = (tr("Parameter"), tr("Motor 1"), tr("Motor 2"))
        self.titles = {
            "motors": tr("Motors and speed ramp"),
            "braking": tr("Braking"),
            "current": tr("Current"),
            "pwm": tr("PWM"),
            "channels": tr("Inputs"),
            "serial": tr("Serial"),
            "system": tr("System"),
        }
        self._motor_colors = {ParameterColumn.MOTOR1: "motor1", ParameterColumn.MOTOR2: "motor2"}
        self._sources: dict[int, Callable[[str], Any]] = {  # role → getter of a value's data
            Qt.ItemDataRole.DisplayRole: self.text.value,
            Qt.ItemDataRole.EditRole: self._number,
            Qt.ItemDataRole.AccessibleTextRole: self.text.spoken,
            ParameterRole.KEY: str,
            ParameterRole.DIRTY: lambda key: any(
                map(self.values.is_modified, self.text.keys_of(key))
            ),
            ParameterRole.ACTIVE: lambda key: self.values.active.get(key),  # noqa: PLW0108
            ParameterRole.PROBLEM: self._problem,
            ParameterRole.RESET: self._reset_text,
        }

    # --- Reports from the device --------------------------------------------------------

    def load(
        self,
        specs: ParameterSet,
        stored: Mapping[str, int],
        unread: Mapping[str, str],
        *,
        power_cycled: bool,
        active: Mapping[str, int] | None = None,
        open_ended: bool = False,
        keep_edits: bool = True,
    ) -> None:
        """Load stored values, and the errors of unread parameters.

        `keep_edits` retains edits if the model is the same. `active` contains values that are known
        to be active. `open_ended` is for a file, in which every parameter is optional.
        """
        pending = self.values.modified
        readable = sorted(specs.readable, key=lambda spec: _GROUPS.index(spec.group))
        loaded = {spec.key: spec for spec in readable}
        has_other_rows = loaded != self.values.specs or specs.model.key != self.model_key
        if has_other_rows:  # only then, because a model reset closes an open editor
            self.beginResetModel()
            self.values.specs.clear()
            self.values.specs.update(loaded)
            self.text.set_board(specs.model)
            self._arrange_rows()
        self.values.load(
            stored,
            keep_edits=keep_edits and specs.model.key == self.model_key,
            power_cycled=power_cycled,
            optional=self.values.specs if open_ended else (),
        )
        for key, wire in (active or {}).items():
            self.values.record_active(key, wire)
        self.model_key = specs.model.key
        problems = self.values.problems.items()
        failed_edits = {key: reason for key, reason in problems if self.values.is_modified(key)}
        self.values.problems = failed_edits | dict(unread)
        if has_other_rows:
            self.endResetModel()
        else:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self.rows) - 1, _COLUMNS - 1))
        if pending != self.values.modified:
            self.pending_changed.emit()

    def _arrange_rows(self) -> None:
        groups: dict[str, list[ParameterRow]] = {group: [] for group in self.titles}
        for key, spec in self.values.specs.items():
            has_own_row = key == self.text.keys_of(key)[-1] and not key.startswith("motor2_")
            if has_own_row:
                other = other_motor_key(key)
                keys = (key,) if other is None else (key, other)
                groups[spec.task].append(ParameterRow(spec.task, self.text.short_title(key), keys))
        self.rows = []
        for group, rows in groups.items():
            if rows:
                self.rows += [ParameterRow(group, self.titles[group]), *rows]
        self._positions = {
            cell_key: (index, column)
            for index, row in enumerate(self.rows)
            for column, key in enumerate(row.keys, ParameterColumn.MOTOR1)
            for cell_key in self.text.keys_of(key)
        }

    def record_stored(self, stored: Mapping[str, int]) -> None:
        for key, wire in stored.items():
            if key in self.values.specs and wire != self.values.stored.get(key):
                self.values.record_stored(self.values.specs[key], wire)
                self._emit_changed(key)
        self.pending_changed.emit()

    def record_results(self, results: Sequence[WriteResult]) -> None:
        for result in results:
            if result.key in self.values.specs:
                self.values.problems.pop(result.key, None)
                if result.error is not None:
                    self.values.problems[result.key] = str(result.error)
                self._emit_changed(result.key)

    def set_accepted(self, accepted: Accepted) -> None:
        """Set the values outside inferred limits that boards are known to store."""
        if accepted == self.values.accepted:
            return
        self.values.accepted = dict(accepted)
        for key in accepted:
            if key in self._positions:
                self._emit_changed(key)
        self.pending_changed.emit()

    # --- Values -------------------------------------------------------------------------

    @property
    def count(self) -> int:
        """Number of settings. A setting of both motors counts once."""
        return sum(bool(row.keys) for row in self.rows)

    def is_editable(self, key: str) -> bool:
        return all(self.values.can_edit(cell_key) for cell_key in self.text.keys_of(key))

    def key_with_open_values(self, key: str) -> str | None:
        """Return the first parameter of a row that accepts values outside its limits, or `None`."""
        specs = (self.values.specs[cell_key] for cell_key in self.text.keys_of(key))
        keys = (spec.key for spec in specs if spec.has_open_values)
        return next(keys, None) if self.is_editable(key) else None

    # --- Edits --------------------------------------------------------------------------

    def edit(self, key: str, wire: int, *, alone: bool = False, forced: bool = False) -> None:
        """Edit a value. Setting the stored value removes the edit.

        If `both_motors` is set, the other motor gets the same value, unless `alone`. `forced`
        allows values outside inferred limits.

        Raises:
            BadRequest: the value is outside the parameter's limits.
            KeyError: the parameter does not exist, or was not read.
        """
        if not self.values.can_edit(key):
            raise KeyError(key)
        keys = (key,) if alone else self._with_other_motor((key,))
        self._edit({key: wire}, keys, forced=forced)

    def edit_frequency(self, key: str, code: int) -> None:
        keys = self.text.keys_of(key)
        self._edit(dict(zip(keys, frequency_wires(code), strict=True)), self._keys_to_change(key))

    def _edit(
        self, values: Mapping[str, int], keys: Sequence[str], *, forced: bool = False
    ) -> None:
        if all(wire == self.values.value_of(key) for key, wire in values.items()):
            return  # closing an unchanged editor must not edit the other motor
        wires = {key: values.get(key, values.get(other_motor_key(key) or "", 0)) for key in keys}
        for key, wire in wires.items():
            if wire != self.values.stored.get(key):
                self.values.specs[key].check(
                    wire, forced=forced or not self.values.is_doubtful(key, wire)
                )
        self._change(wires)

    def reset(self, key: str) -> None:
        """Set a value to its default, as an edit."""
        if self.is_editable(key):
            keys = self._keys_to_change(key)
            self._change({cell_key: self.values.specs[cell_key].default for cell_key in keys})

    def restore(self, key: str) -> None:
        """Discard the edit of a value."""
        if self.is_editable(key):
            keys = self._keys_to_change(key)
            self._change({cell_key: self.values.stored.get(cell_key) for cell_key in keys})

    def remove(self, key: str) -> None:
        if self.values.can_remove(key):
            self._change(dict.fromkeys(filter(self.values.can_remove, self._keys_to_change(key))))

    def discard_edits(self) -> None:
        """Restore the stored values, with an undo step for each value."""
        for key in self.values.modified:
            self._change({key: self.values.stored.get(key)})

    def _with_other_motor(self, keys: Sequence[str]) -> tuple[str, ...]:
        others = map(self.values.other_motor_of, keys if self.both_motors else ())
        return (*keys, *filter(None, others))

    def _keys_to_change(self, key: str) -> tuple[str, ...]:
        return self._with_other_motor(self.text.keys_of(key))

    def _change(self, wires: Mapping[str, int | None]) -> None:
        """Push changed values as one undo step."""
        edits = [
            Edit(self.values.specs[key].name, self._apply_edit, key, before, wire)
            for key, wire in wires.items()
            if wire != (before := self.values.value_of(key))
        ]
        if len(edits) > 1:
            key = next(iter(wires))
            title, motor = self.text.title(key), motor_name(key)
            if any(motor_name(other) != motor for other in wires):
                title = tr("Motors 1 and 2 {0}").format(self.text.short_title(key))
            self._undo.beginMacro(title)
        for edit in edits:
            self._undo.push(edit)
        if len(edits) > 1:
            self._undo.endMacro()

    def _apply_edit(self, key: str, wire: int | None) -> None:
        """Apply an edit. Ignore a parameter that the current board lacks."""
        if self.values.can_edit(key):
            if wire is None:
                self.values.remove(key)
            else:
                self.values.edit(self.values.specs[key], wire)
            self._emit_changed(key)
            self.pending_changed.emit()

    # --- Qt -----------------------------------------------------------------------------

    def index_of(self, key: str) -> QModelIndex:
        position = self._positions.get(key)
        return QModelIndex() if position is None else self.index(*position)

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else _COLUMNS

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or not 0 <= section < _COLUMNS:
            return None
        color = self._motor_colors.get(ParameterColumn(section))
        if role == Qt.ItemDataRole.ForegroundRole and color:
            return theme().color(color)
        return self._headers[section] if role == Qt.ItemDataRole.DisplayRole else None

    def _key_at(self, index: Index) -> str:
        keys = self.rows[index.row()].keys if index.isValid() else ()
        return keys[min(max(index.column() - 1, 0), len(keys) - 1)] if keys else ""

    def flags(self, index: Index) -> Qt.ItemFlag:
        key = self._key_at(index)
        if not key:
            return _HEADING
        is_value = index.column() != ParameterColumn.NAME
        return _EDITABLE if is_value and self.is_editable(key) else _FIXED

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        source = self._sources.get(role)
        if (source is None and role != ParameterRole.GROUP) or not index.isValid():
            return None
        key = self._key_at(index)
        if not key:
            return self._heading_data(index, role)
        if role == Qt.ItemDataRole.DisplayRole and index.column() == ParameterColumn.NAME:
            return self.rows[index.row()].name
        return None if source is None else source(key)

    def _number(self, key: str) -> int | None:
        wires = self.text.wires(key)
        return _edit_value(wires) if len(wires) == len(self.text.keys_of(key)) else None

    def default_number(self, key: str) -> int:
        specs = self.values.specs
        return _edit_value([specs[cell_key].default for cell_key in self.text.keys_of(key)])

    def _problem(self, key: str) -> str | None:
        return next(filter(None, map(self.values.problems.get, self.text.keys_of(key))), None)

    def _reset_text(self, key: str) -> str | None:
        differs = any(map(self.values.differs_from_default, self.text.keys_of(key)))
        return self.text.reset(key) if differs else None

    def _heading_data(self, index: Index, role: int) -> Any:
        heading = self.rows[index.row()]
        if role == ParameterRole.GROUP:
            return heading.group
        if role != Qt.ItemDataRole.DisplayRole or index.column() > 0:
            return None
        members = (row for row in self.rows if row.group == heading.group)
        keys = (
            cell_key for row in members for key in row.keys for cell_key in self.text.keys_of(key)
        )
        modified = sum(map(self.values.is_modified, keys))
        text = tr("{0} ({1} modified)") if modified else "{0}"
        return text.format(heading.name, modified)

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or not self.flags(index) & Qt.ItemFlag.ItemIsEditable:
            return False
        key = self._key_at(index)
        change = self.edit if len(self.text.keys_of(key)) == 1 else self.edit_frequency
        try:
            change(key, int(value))
        except BadRequest as error:
            self.rejected.emit(error_sentence(error))
            return False
        except (TypeError, ValueError, OverflowError):
            self.rejected.emit(
                tr("{0}: {1} is not a valid value.").format(self.text.title(key), value)
            )
            return False
        return True

    # --- Change notification ------------------------------------------------------------

    def _emit_changed(self, key: str) -> None:
        row = self._positions[key][0]
        heading = next(index for index in range(row, -1, -1) if not self.rows[index].keys)
        for changed in (row, heading):
            self.dataChanged.emit(self.index(changed, 0), self.index(changed, _COLUMNS - 1))
