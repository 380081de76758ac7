"""The parameters as a table: what is stored, what is edited, what is not yet in force."""

from collections.abc import Mapping, Sequence
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

from trex_gui.link.writing import Written
from trex_gui.model.draft import Draft
from trex_gui.model.undo import Edit
from trex_gui.protocol.device_table import device_table
from trex_gui.protocol.errors import BadRequest, sentence
from trex_gui.protocol.parameters import Kind, ParameterSet, ParameterSpec

Index = QModelIndex | QPersistentModelIndex


class Column(IntEnum):
    """The columns, left to right."""

    NAME = 0
    VALUE = 1
    WIRE = 2
    DEFAULT = 3
    RANGE = 4
    EFFECT = 5


class Role(IntEnum):
    """What a cell tells besides its text."""

    SPEC = Qt.ItemDataRole.UserRole
    WIRE = Qt.ItemDataRole.UserRole + 1
    DIRTY = Qt.ItemDataRole.UserRole + 2
    WAITING = Qt.ItemDataRole.UserRole + 3
    PROBLEM = Qt.ItemDataRole.UserRole + 4


class ParameterModel(QAbstractTableModel):
    """One row a parameter; edits wait in a draft until they are applied.

    Every edit goes over the undo stack that it is given (or has one of its own).

    Signals:
        pending_changed: how many edits wait.
        refused: why an edit was not taken, for people.
    """

    pending_changed = Signal(int)
    refused = Signal(str)

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self._undo = undo or QUndoStack(self)
        self._specs: tuple[ParameterSpec, ...] = ()
        self._draft = Draft()
        self._problems: dict[str, str] = {}
        self._editable = False
        self._model_key = ""
        self._headers = (
            self.tr("Parameter"),
            self.tr("Value"),
            self.tr("Wire"),
            self.tr("Default"),
            self.tr("Range"),
            self.tr("Takes effect"),
        )

    # --- What the device says -----------------------------------------------------------

    def load(
        self,
        specs: ParameterSet,
        stored: Mapping[str, int],
        unread: Mapping[str, str],
        *,
        power_cycled: bool,
    ) -> None:
        """Take everything that was read; edits stay when it is the same model of board."""
        pending = len(self._draft.edited)
        same = specs.model.key == self._model_key
        self.beginResetModel()
        self._specs = specs.readable
        self._model_key = specs.model.key
        self._draft.load(stored, keep_edits=same, power_cycled=power_cycled)
        kept = {key: why for key, why in self._problems.items() if key in self._draft.edited}
        self._problems = {**kept, **unread}
        self._editable = True
        self.endResetModel()
        if pending != len(self._draft.edited):
            self.pending_changed.emit(len(self._draft.edited))

    def note_in_force(self, in_force: Mapping[str, int]) -> None:
        """Take what is surely in force now of what acts only after a power cycle."""
        for key, wire in in_force.items():
            self._draft.note_in_force(key, wire)
        self._announce_rows(0, len(self._specs) - 1)
        self.pending_changed.emit(len(self._draft.edited))

    def set_editable(self, editable: bool) -> None:
        """Say whether a board is there to write to; the rows stay to be looked at."""
        if editable != self._editable:
            self._editable = editable
            self._announce_rows(0, len(self._specs) - 1)

    def take_results(self, results: Sequence[Written]) -> None:
        """Take what was read back after a write, and why something did not stick."""
        for result in results:
            row = self._row_of(result.what)
            if row is None:
                continue
            spec = self._specs[row]
            if isinstance(result.stored, int):
                self._draft.note_stored(spec, result.stored)
                self._problems.pop(spec.key, None)
            elif result.error is not None:
                self._problems[spec.key] = str(result.error)
            self._announce_rows(row, row)
        self.pending_changed.emit(len(self._draft.edited))

    # --- What a person does -------------------------------------------------------------

    @property
    def pending(self) -> tuple[tuple[str, int], ...]:
        """What Apply would write: key and wire value."""
        return self._draft.pending

    @property
    def all_stored(self) -> dict[str, int]:
        """What is stored, as far as it was read: wire values by key, in the order of the table."""
        return {s.key: self._draft.stored[s.key] for s in self._specs if self._is_stored(s.key)}

    @property
    def all_shown(self) -> dict[str, int]:
        """What would be stored after Apply, likewise."""
        return {**self.all_stored, **self._draft.edited}

    def spec_of(self, key: str) -> ParameterSpec:
        """Return the entry of the parameter table.

        Raises:
            KeyError: there is no such parameter here.
        """
        row = self._row_of(key)
        if row is None:
            raise KeyError(key)
        return self._specs[row]

    @property
    def model_key(self) -> str:
        """The kind of board that the rows are of; empty before the first."""
        return self._model_key

    @property
    def waiting_for_power(self) -> tuple[str, ...]:
        """Names of the parameters that are stored and act only after a power cycle."""
        return tuple(spec.name for spec in self._specs if spec.key in self._draft.active)

    def discard_edits(self) -> None:
        """Go back to what is stored; this can be undone."""
        if not self._draft.edited:
            return
        self._undo.beginMacro(self.tr("Discard edits"))
        for key in list(self._draft.edited):
            self.edit(key, self._draft.stored[key])
        self._undo.endMacro()

    def edit(self, key: str, wire: int) -> None:
        """Wish for a wire value; wishing for the stored one forgets the edit.

        Raises:
            BadRequest: the table does not allow the value.
            KeyError: there is no such parameter, or it was not read.
        """
        row = self._row_of(key)
        if row is None or not self._is_known(row):
            raise KeyError(key)
        spec = self._specs[row]
        before = self._draft.value(key)
        if wire != before and wire != self._draft.stored[key]:
            spec.check(wire)
        if before is not None and wire != before:
            self._undo.push(Edit(spec.name, self._put, key, before, wire))

    def _put(self, key: str, wire: int) -> None:
        """Put a value in its place; a board that no longer has the parameter is left alone."""
        row = self._row_of(key)
        if row is not None and self._is_known(row):
            self._draft.edit(self._specs[row], wire)
            self._announce_rows(row, row)
            self.pending_changed.emit(len(self._draft.edited))

    def value_of(self, key: str) -> int | None:
        """Wire value that would be in the device after Apply; `None` when it was not read."""
        return self._draft.value(key)

    def stored_of(self, key: str) -> int | None:
        """Wire value that is in the device; `None` when it was not read."""
        return self._draft.stored.get(key)

    def active_of(self, key: str) -> int | None:
        """Wire value that is in force; `None` when it was not read.

        It differs from what is stored until the power is cycled.
        """
        return self._draft.active.get(key, self._draft.stored.get(key))

    def index_of(self, key: str, column: Column = Column.VALUE) -> QModelIndex:
        """Return the cell of a parameter, invalid when there is none."""
        row = self._row_of(key)
        return QModelIndex() if row is None else self.index(row, column)

    # --- Qt -----------------------------------------------------------------------------

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._specs)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(Column)

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        horizontal = orientation is Qt.Orientation.Horizontal
        if horizontal and role == Qt.ItemDataRole.DisplayRole and section < len(Column):
            return self._headers[section]
        if horizontal and role == Qt.ItemDataRole.TextAlignmentRole and section == Column.WIRE:
            return int(Qt.AlignmentFlag.AlignCenter)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        flags = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemNeverHasChildren
        if self._editable:
            flags |= Qt.ItemFlag.ItemIsEnabled
            if index.column() == Column.VALUE and self._is_known(index.row()):
                flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        spec = self._specs[index.row()]
        wire = self._draft.value(spec.key)
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._text(spec, wire, Column(index.column()))
            case Qt.ItemDataRole.EditRole | Role.WIRE:
                return wire
            case Role.SPEC:
                return spec
            case Role.DIRTY:
                return spec.key in self._draft.edited
            case Role.WAITING:
                return self._draft.active.get(spec.key)
            case Role.PROBLEM:
                return self._problems.get(spec.key)
            case Qt.ItemDataRole.ToolTipRole:
                return self._tool_tip(spec)
            case Qt.ItemDataRole.TextAlignmentRole if index.column() == Column.WIRE:
                return int(Qt.AlignmentFlag.AlignCenter)
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or not index.isValid():
            return False
        if not self.flags(index) & Qt.ItemFlag.ItemIsEditable:
            return False
        spec = self._specs[index.row()]
        try:
            self.edit(spec.key, int(value))
        except BadRequest as error:
            self.refused.emit(sentence(error))
            return False
        except (TypeError, ValueError, OverflowError):
            self.refused.emit(f"{spec.name} is {spec.range_text()}, not {value}.")
            return False
        return True

    # --- Text ---------------------------------------------------------------------------

    def _text(self, spec: ParameterSpec, wire: int | None, column: Column) -> str:
        match column:
            case Column.NAME:
                return spec.name
            case Column.VALUE:
                return self.tr("not read") if wire is None else self._value_text(spec, wire)
            case Column.WIRE:
                return "" if wire is None else str(wire)
            case Column.DEFAULT:
                return spec.text(spec.default)
            case Column.RANGE:
                return spec.short_range()
            case Column.EFFECT:
                return self.tr("power cycle") if spec.needs_power_cycle else self.tr("at once")

    def _value_text(self, spec: ParameterSpec, wire: int) -> str:
        """Add what follows from a value together with others: frequency, time to full speed."""
        text = spec.text(wire)
        if spec.kind is Kind.PWM_MAXIMUM:
            prescaler = self._draft.value(spec.key.replace("maximum", "prescaler"))
            if prescaler is not None:
                hertz = device_table().pwm.frequency(prescaler, wire)
                return self.tr("{0} ({1:.0f} Hz)").format(text, hertz)
        if spec.kind is Kind.ACCELERATION and wire:
            return self.tr("{0} ({1:.1f} s to full speed)").format(text, 12.7 / wire)
        return text

    def _tool_tip(self, spec: ParameterSpec) -> str:
        parts = [spec.description]
        if problem := self._problems.get(spec.key):
            parts.append(problem)
        return "\n\n".join(parts)

    # --- Small things -------------------------------------------------------------------

    def _is_known(self, row: int) -> bool:
        return self._is_stored(self._specs[row].key)

    def _is_stored(self, key: str) -> bool:
        return key in self._draft.stored

    def _row_of(self, key: str) -> int | None:
        return next((row for row, spec in enumerate(self._specs) if spec.key == key), None)

    def _announce_rows(self, first: int, last: int) -> None:
        if last >= first:
            self.dataChanged.emit(self.index(first, 0), self.index(last, len(Column) - 1))
