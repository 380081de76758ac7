"""The parameters of a board or a file with their edits, as a Qt model."""

from collections.abc import Callable, Iterable, Mapping, Sequence
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
from trex_gui.devices.trex.model.parameters.draft import Draft
from trex_gui.devices.trex.model.parameters.text import (
    ParameterColumn,
    ParameterText,
    frequency_code,
    frequency_wires,
)
from trex_gui.devices.trex.protocol.parameters import (
    ParameterSet,
    ParameterSpec,
    motor_name,
    other_motor_key,
)
from trex_gui.devices.trex.settings.accepted import Accepted
from trex_gui.devices.trex.settings.comparison import ComparisonRow
from trex_gui.ui.devices.undo import Edit
from trex_gui.ui.translations import error_sentence

Index = QModelIndex | QPersistentModelIndex

_COLUMNS = len(ParameterColumn)
_GROUPS = ("motors", "channels", "serial", "system")  # in the order of settings files
_PINNED = "pinned"  # the group of the rows that the user keeps at the top

# Made once, and looked at first: Qt asks a thousand times whenever the table is painted.
_HEADING = Qt.ItemFlag.NoItemFlags  # keys pass it by
_FIXED = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemNeverHasChildren
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

    RESET is the effect of a reset to the default, `None` where nothing differs. The name of a row
    has the data of its first value.
    """

    KEY = Qt.ItemDataRole.UserRole
    DIRTY = Qt.ItemDataRole.UserRole + 1
    WAITING = Qt.ItemDataRole.UserRole + 2
    PROBLEM = Qt.ItemDataRole.UserRole + 3
    GROUP = Qt.ItemDataRole.UserRole + 4
    RESET = Qt.ItemDataRole.UserRole + 5


@dataclass(frozen=True, slots=True)
class _Row:
    """A heading, or one setting: of motors 1 and 2, or of the board in `keys[0]` alone."""

    group: str
    name: str = ""
    keys: tuple[str, ...] = ()


def _pin(keys: Sequence[str]) -> str:
    """Return what a pinned row is remembered by: its key, without the motor."""
    return keys[0].removeprefix("motor1_")


def _number(wires: Sequence[int]) -> int:
    return wires[0] if len(wires) == 1 else frequency_code(*wires)


class ParameterModel(QAbstractTableModel):
    """Headings and rows of settings, one column for each motor; edits go over an undo stack.

    Prescaler and maximum of a PWM are one value in the table, its frequency: that of the key of
    either, and a number (`frequency_code`) in the edit role.
    """

    pending_changed = Signal(int)  # the number of edits
    rejected = Signal(str)  # why an edit was rejected, for the user
    rounded = Signal(str)  # which value an edit has become, for the user

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self._undo = undo or QUndoStack(self)
        self._specs: dict[str, ParameterSpec] = {}
        self._rows: list[_Row] = []
        self._places: dict[str, tuple[int, int]] = {}  # row and column
        self._pinned: tuple[str, ...] = ()
        self._draft = Draft()
        self._problems: dict[str, str] = {}
        self._accepted: dict[str, frozenset[int]] = {}
        self.text = ParameterText(self._specs, self._draft, self._problems, self._accepted, self)
        self.model_key = ""  # the kind of board that the rows belong to; empty before the first
        self.both_motors = False  # whether an edit for one motor is made for the other, too
        self._headers = (tr("Parameter"), tr("Motor 1"), tr("Motor 2"))
        self._sources: dict[int, Callable[[str], Any]] = {  # of the data of a value, by role
            Qt.ItemDataRole.DisplayRole: self.text.value,
            Qt.ItemDataRole.EditRole: self._number,
            Qt.ItemDataRole.ToolTipRole: self.text.tool_tip,
            Qt.ItemDataRole.AccessibleTextRole: self.text.spoken,
            Role.KEY: str,
            Role.DIRTY: self._is_dirty,
            Role.WAITING: self._waiting,
            Role.PROBLEM: self._problem,
            Role.RESET: self._reset_text,
        }
        self._titles = {
            _PINNED: tr("Pinned"),
            "motors": tr("Motors and speed ramp"),
            "braking": tr("Braking"),
            "current": tr("Current"),
            "pwm": tr("PWM"),
            "channels": tr("Inputs"),
            "serial": tr("Serial"),
            "system": tr("System"),
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
        keep_edits: bool = True,
    ) -> None:
        """Take everything that was read; with `keep_edits` they stay if the model is the same.

        `active` are values known to be active, whatever is stored. `open_ended` (a file): any
        parameter may be added or left out.
        """
        pending = self.modified
        self.beginResetModel()
        self._specs.clear()
        for spec in sorted(specs.readable, key=lambda spec: _GROUPS.index(spec.group)):
            self._specs[spec.key] = spec
        self.text.set_board(specs.model)
        self._arrange()
        self._draft.load(
            stored,
            keep_edits=keep_edits and specs.model.key == self.model_key,
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

    def _arrange(self) -> None:
        """Make the rows of the parameters: those pinned first, the others by task."""
        groups: dict[str, list[_Row]] = {group: [] for group in self._titles}
        for key, spec in self._specs.items():
            is_named_by_another = key != self.text.together(key)[-1] or key.startswith("motor2_")
            if not is_named_by_another:
                other = other_motor_key(key)
                name = self.text.short_title(key)
                keys = (key,) if other is None else (key, other)
                group = _PINNED if _pin(keys) in self._pinned else spec.task
                groups[group].append(_Row(group, name, keys))
        groups[_PINNED].sort(key=lambda row: self._pinned.index(_pin(row.keys)))
        self._rows = []
        for group, rows in groups.items():
            if rows:
                self._rows += [_Row(group, self._titles[group]), *rows]
        self._places = {
            each: (place, column)
            for place, row in enumerate(self._rows)
            for column, key in enumerate(row.keys, ParameterColumn.MOTOR1)
            for each in self.text.together(key)
        }

    @property
    def pinned(self) -> tuple[str, ...]:
        """Keys of the rows that are kept at the top, without the motor."""
        return self._pinned

    def pin(self, keys: Iterable[str]) -> None:
        self.beginResetModel()
        self._pinned = tuple(keys)
        self._arrange()
        self.endResetModel()

    def is_pinned(self, key: str) -> bool:
        return self._rows[self._places[key][0]].group == _PINNED

    def toggle_pin(self, key: str) -> None:
        pin = _pin(self._rows[self._places[key][0]].keys)
        others = [each for each in self._pinned if each != pin]
        self.pin(others if self.is_pinned(key) else [*others, pin])

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

    def set_accepted(self, accepted: Accepted) -> None:
        """Set which values beyond inferred limits boards with this firmware have stored."""
        if accepted == self._accepted:
            return
        self._accepted.clear()
        self._accepted.update(accepted)
        for key in accepted:
            if key in self._places:
                self._announce(key)
        self._announce_pending()

    # --- Values -------------------------------------------------------------------------

    @property
    def count(self) -> int:
        """The number of settings, one for both motors."""
        return sum(bool(row.keys) for row in self._rows)

    @property
    def tasks(self) -> dict[str, str]:
        """The titles of the tasks that have parameters, by task."""
        tasks = {spec.task for spec in self._specs.values()}
        return {task: title for task, title in self._titles.items() if task in tasks}

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
    def all_active(self) -> dict[str, int]:
        """The active wire values that differ from the stored ones, by key."""
        return dict(self._draft.active)

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

    def is_editable(self, key: str) -> bool:
        """Whether a value of the table can be edited."""
        return all(self.can_edit(each) for each in self.text.together(key))

    def can_leave_out(self, key: str) -> bool:
        return key in self._draft.optional and self.value_of(key) is not None

    def open_key(self, key: str) -> str | None:
        """Return the parameter of a value for which others than its limits allow can be tried."""
        keys = (each for each in self.text.together(key) if self._specs[each].has_open_values)
        return next(keys, None) if self.is_editable(key) else None

    def is_doubtful(self, key: str, wire: int) -> bool:
        """Whether only a board can tell if it takes this value, and none has yet."""
        is_known = wire in self._accepted.get(key, ()) or wire == self.stored_of(key)
        return self._specs[key].is_open(wire) and not is_known

    def doubtful(self, rows: Iterable[ComparisonRow]) -> list[str]:
        """Return the values to be written that are doubtful, for the user."""
        return [
            tr("{0} {1}").format(row.name, row.after)
            for row in rows
            if isinstance(row.after, int) and self.is_doubtful(row.key, row.after)
        ]

    def other_motor_of(self, key: str) -> str | None:
        """Return the same parameter of the other motor if both can be edited."""
        other_motor = other_motor_key(key)
        if other_motor is None or not self.can_edit(key) or not self.can_edit(other_motor):
            return None
        return other_motor

    # --- Edits --------------------------------------------------------------------------

    def edit(self, key: str, wire: int, *, alone: bool = False, forced: bool = False) -> None:
        """Edit a value; the stored value drops the edit.

        With `both_motors`, the other motor gets the value in the same step, except with `alone`.
        `forced` allows values beyond limits that are only inferred.

        Raises:
            BadRequest: the value is outside the parameter's limits.
            KeyError: the parameter does not exist, or was not read.
        """
        if not self.can_edit(key):
            raise KeyError(key)
        keys = (key,) if alone else self._with_other_motor((key,))
        self._edit({key: wire}, keys, forced=forced)

    def edit_frequency(self, key: str, code: int) -> None:
        """Edit prescaler and maximum of a PWM in one step; see `edit`."""
        keys = self.text.together(key)
        self._edit(dict(zip(keys, frequency_wires(code), strict=True)), self._all_with(key))

    def _edit(
        self, values: Mapping[str, int], keys: Sequence[str], *, forced: bool = False
    ) -> None:
        """Edit values; the other motor's keys get the values of their counterparts."""
        if all(wire == self.value_of(key) for key, wire in values.items()):
            return  # an editor that was opened and left does not edit the other motor either
        wanted = {key: values.get(key, values.get(other_motor_key(key) or "", 0)) for key in keys}
        for key, wire in wanted.items():
            if wire != self.stored_of(key):
                self._specs[key].check(wire, forced=forced or not self.is_doubtful(key, wire))
        self._change(wanted)

    def reset(self, key: str) -> None:
        if self.is_editable(key):
            self._change({each: self._specs[each].default for each in self._all_with(key)})

    def restore(self, key: str) -> None:
        """Go back to the stored value; with `both_motors`, each to its own."""
        if self.is_editable(key):
            self._change({each: self.stored_of(each) for each in self._all_with(key)})

    def leave_out(self, key: str) -> None:
        if self.can_leave_out(key):
            self._change(dict.fromkeys(filter(self.can_leave_out, self._all_with(key))))

    def copy_to_other_motor(self, key: str) -> None:
        self._change(
            {
                other: self.value_of(each)
                for each in self.text.together(key)
                if (other := self.other_motor_of(each)) and self.value_of(each) is not None
            }
        )

    def discard_edits(self) -> None:
        """Go back to the stored values, one undo step for each."""
        for key in self.modified:
            self._change({key: self.stored_of(key)})

    def _with_other_motor(self, keys: Sequence[str]) -> tuple[str, ...]:
        others = map(self.other_motor_of, keys if self.both_motors else ())
        return (*keys, *filter(None, others))

    def _all_with(self, key: str) -> tuple[str, ...]:
        """Return the keys of a value of the table, with `both_motors` those of both."""
        return self._with_other_motor(self.text.together(key))

    def _change(self, wanted: Mapping[str, int | None]) -> None:
        """Push edits of the values that differ, as one undo step."""
        edits = [
            Edit(self._specs[key].name, self._put, key, before, wire)
            for key, wire in wanted.items()
            if wire != (before := self.value_of(key))
        ]
        if len(edits) > 1:
            key = next(iter(wanted))
            title, motor = self.text.title(key), motor_name(key)
            if any(motor_name(other) != motor for other in wanted):
                title = tr("Motors 1 and 2 {0}").format(self.text.short_title(key))
            self._undo.beginMacro(title)
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

    def index_of(self, key: str) -> QModelIndex:
        """Return the cell with the value of a parameter, invalid when there is none."""
        place = self._places.get(key)
        return QModelIndex() if place is None else self.index(*place)

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else _COLUMNS

    def keys_at(self, row: int) -> tuple[str, ...]:
        """Return a key for each value of a row: of motors 1 and 2, of the board, or none."""
        return self._rows[row].keys

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        is_shown = orientation is Qt.Orientation.Horizontal and section < _COLUMNS
        return self._headers[section] if is_shown and role == Qt.ItemDataRole.DisplayRole else None

    def _key_at(self, index: Index) -> str:
        """Return the key of a cell; empty in a heading."""
        keys = self._rows[index.row()].keys if index.isValid() else ()
        return keys[min(max(index.column() - 1, 0), len(keys) - 1)] if keys else ""

    def flags(self, index: Index) -> Qt.ItemFlag:
        key = self._key_at(index)
        if not key:
            return _HEADING
        is_value = index.column() != ParameterColumn.NAME
        return _EDITABLE if is_value and self.is_editable(key) else _FIXED

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role in _LEFT_TO_THE_STYLE or not index.isValid():
            return None
        key = self._key_at(index)
        if not key:
            return self._heading_data(index, role)
        if role == Qt.ItemDataRole.DisplayRole and index.column() == ParameterColumn.NAME:
            return self._rows[index.row()].name
        source = self._sources.get(role)
        return None if source is None else source(key)

    def _number(self, key: str) -> int | None:
        """Return what an editor shows: a wire value, or the code of a frequency."""
        wires = [self.value_of(each) for each in self.text.together(key)]
        known = [wire for wire in wires if wire is not None]
        return _number(known) if len(known) == len(wires) else None

    def default_number(self, key: str) -> int:
        return _number([self._specs[each].default for each in self.text.together(key)])

    def _is_dirty(self, key: str) -> bool:
        return any(map(self.is_modified, self.text.together(key)))

    def _waiting(self, key: str) -> int | None:
        return self._draft.active.get(key)

    def _problem(self, key: str) -> str | None:
        return next(filter(None, map(self._problems.get, self.text.together(key))), None)

    def _reset_text(self, key: str) -> str | None:
        keys = self.text.together(key)
        differs = any(self.value_of(each) not in {None, self._specs[each].default} for each in keys)
        return self.text.reset(key) if differs else None

    def _heading_data(self, index: Index, role: int) -> Any:
        heading = self._rows[index.row()]
        if role == Role.GROUP:
            return heading.group
        if role != Qt.ItemDataRole.DisplayRole or index.column() > 0:
            return None
        members = (row for row in self._rows if row.group == heading.group)
        keys = (each for row in members for key in row.keys for each in self.text.together(key))
        modified = sum(map(self.is_modified, keys))
        text = tr("{0} ({1} modified)") if modified else "{0}"
        return text.format(heading.name, modified)

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or not self.flags(index) & Qt.ItemFlag.ItemIsEditable:
            return False
        key = self._key_at(index)
        change = self.edit if len(self.text.together(key)) == 1 else self.edit_frequency
        try:
            change(key, int(value))
        except BadRequest as error:
            self.rejected.emit(error_sentence(error))
            return False
        except (TypeError, ValueError, OverflowError):
            self.rejected.emit(f"{self.text.title(key)} is not {value}.")
            return False
        return True

    # --- Change notification ------------------------------------------------------------

    def _announce_pending(self) -> None:
        self.pending_changed.emit(len(self.modified))

    def _announce(self, key: str) -> None:
        """Announce the row of a parameter, and the heading above it."""
        row = self._places[key][0]
        heading = next(each for each in range(row, -1, -1) if not self._rows[each].keys)
        for place in (row, heading):
            self.dataChanged.emit(self.index(place, 0), self.index(place, _COLUMNS - 1))
