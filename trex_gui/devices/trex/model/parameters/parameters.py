"""The parameters of a board or a file: what is stored, edited, and not yet in force."""

from collections.abc import Mapping, Sequence
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest, sentence
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.parameters.tree import (
    GROUPS,
    Index,
    ParameterColumn,
    ParameterTree,
    Role,
)
from trex_gui.devices.trex.protocol.parameters import (
    ParameterSet,
    ParameterSpec,
    motor_name,
    other_motor_key,
)
from trex_gui.ui.devices.undo import Edit

__all__ = ["GROUPS", "Index", "ParameterColumn", "ParameterModel", "Role"]


class ParameterModel(ParameterTree):
    """A row a parameter, in groups; edits wait in a draft until they are applied.

    Every edit goes over the undo stack that it is given (or has one of its own).

    Signals:
        pending_changed: how many edits wait.
        rejected: why an edit was not taken, for the user.
    """

    pending_changed = Signal(int)
    rejected = Signal(str)

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self._undo = undo or QUndoStack(self)
        self._both_motors = False
        self._model_key = ""

    # --- What the device says -----------------------------------------------------------

    def load(
        self,
        specs: ParameterSet,
        stored: Mapping[str, int],
        unread: Mapping[str, str],
        *,
        power_cycled: bool,
        open_ended: bool = False,
    ) -> None:
        """Take everything that was read; edits stay when it is the same model of board.

        With `open_ended` (a file) what is not stored can be given, and what is can be left out.
        """
        pending = self.modified
        same = specs.model.key == self._model_key
        self.beginResetModel()
        self._arrange(specs.readable)
        self._model_key = specs.model.key
        self._draft.load(
            stored,
            keep_edits=same,
            power_cycled=power_cycled,
            open_to=self.text.specs if open_ended else (),
        )
        kept = {key: why for key, why in self._problems.items() if self._draft.is_modified(key)}
        self._problems.clear()
        self._problems.update({**kept, **unread})
        self._editable = True
        self.endResetModel()
        if pending != self.modified:
            self.pending_changed.emit(len(self.modified))

    def note_in_force(self, in_force: Mapping[str, int]) -> None:
        """Take what is surely in force now of what acts only after a power cycle."""
        for key, wire in in_force.items():
            self._draft.note_in_force(key, wire)
        self._announce_all()
        self.pending_changed.emit(len(self.modified))

    def set_editable(self, editable: bool) -> None:
        """Say whether a board is there to write to; the rows stay to be looked at."""
        if editable != self._editable:
            self._editable = editable
            self._announce_all()

    def note_stored(self, stored: Mapping[str, int]) -> None:
        """Take the stored values after a verified write."""
        for key, wire in stored.items():
            if key in self.text.specs and wire != self._draft.stored.get(key):
                self._draft.note_stored(self.text.specs[key], wire)
                self._announce(key)
        self.pending_changed.emit(len(self.modified))

    def note_results(self, results: Sequence[WriteResult]) -> None:
        """Take the reasons of failed writes."""
        for result in results:
            if result.key not in self.text.specs:
                continue
            if result.error is None:
                self._problems.pop(result.key, None)
            else:
                self._problems[result.key] = str(result.error)
            self._announce(result.key)

    # --- What is known ------------------------------------------------------------------

    @property
    def pending(self) -> tuple[tuple[str, int], ...]:
        """What Apply would write: key and wire value; what is left out is in `removed`."""
        return self._draft.pending

    @property
    def removed(self) -> tuple[str, ...]:
        """Keys that are stored and would be left out, in the order of the table."""
        return tuple(key for key in self.text.specs if key in self._draft.removed)

    @property
    def modified(self) -> tuple[str, ...]:
        """Keys whose value would be another, or left out, after Apply or Save."""
        return tuple(key for key in self.text.specs if self._draft.is_modified(key))

    def is_modified(self, key: str) -> bool:
        """Whether a parameter would have another value, or none, after Apply or Save."""
        return self._draft.is_modified(key)

    @property
    def all_stored(self) -> dict[str, int]:
        """What is stored, as far as it was read: wire values by key, in the order of the table."""
        stored = self._draft.stored
        return {key: stored[key] for key in self.text.specs if key in stored}

    @property
    def all_shown(self) -> dict[str, int]:
        """What would be stored after Apply, likewise; what is left out is not there."""
        shown = {key: self._draft.value(key) for key in self.text.specs}
        return {key: wire for key, wire in shown.items() if wire is not None}

    def spec_of(self, key: str) -> ParameterSpec:
        """Return the entry of the parameter table.

        Raises:
            KeyError: there is no such parameter here.
        """
        return self.text.specs[key]

    @property
    def model_key(self) -> str:
        """The kind of board that the rows are of; empty before the first."""
        return self._model_key

    @property
    def waiting_for_power(self) -> tuple[str, ...]:
        """Names of the parameters that are stored and act only after a power cycle."""
        specs = self.text.specs.values()
        return tuple(spec.name for spec in specs if spec.key in self._draft.active)

    def value_of(self, key: str) -> int | None:
        """Wire value that would be in the device after Apply; `None`: not read, or left out."""
        return self._draft.value(key)

    def stored_of(self, key: str) -> int | None:
        """Wire value that is in the device; `None` when it was not read."""
        return self._draft.stored.get(key)

    def active_of(self, key: str) -> int | None:
        """Wire value that is in force; `None` when it was not read.

        It differs from what is stored until the power is cycled.
        """
        return self._draft.active.get(key, self._draft.stored.get(key))

    def can_leave_out(self, key: str) -> bool:
        """Whether a parameter is given and need not be."""
        return key in self._draft.open_to and self._draft.value(key) is not None

    def other_motor_of(self, key: str) -> str | None:
        """Return the same parameter of the other motor, if it has one and both are known."""
        other_motor = other_motor_key(key)
        return (
            other_motor
            if other_motor is not None and self.knows(key) and self.knows(other_motor)
            else None
        )

    # --- User actions -----------------------------------------------------------------

    @property
    def both_motors(self) -> bool:
        """Whether an edit for one motor is made for the other, too."""
        return self._both_motors

    def set_both_motors(self, both: bool) -> None:
        """Edit both motors as one from now on, or each alone; values stay as they are."""
        self._both_motors = both

    def edit(self, key: str, wire: int, *, alone: bool = False) -> None:
        """Wish for a wire value; wishing for the stored one forgets the edit.

        While both motors are edited as one, the other one gets the value in the same step,
        except with `alone`.

        Raises:
            BadRequest: the table does not allow the value.
            KeyError: there is no such parameter, or it was not read.
        """
        if not self.knows(key):
            raise KeyError(key)
        if wire == self._draft.value(key):
            return  # an editor that was opened and left does not edit the other motor either
        keys = (key,) if alone else self._with_other_motor(key)
        for each in keys:
            if wire != self._draft.stored.get(each):
                self.text.specs[each].check(wire)
        self._change(dict.fromkeys(keys, wire))

    def reset(self, key: str) -> None:
        """Edit a parameter to its default."""
        if self.knows(key):
            self.edit(key, self.text.specs[key].default)

    def restore(self, key: str) -> None:
        """Go back to what is stored; with its twin, each to its own."""
        if self.knows(key):
            self._change(
                {each: self._draft.stored.get(each) for each in self._with_other_motor(key)}
            )

    def leave_out(self, key: str) -> None:
        """Give a parameter no value; only where it need not have one."""
        if self.can_leave_out(key):
            keys = [each for each in self._with_other_motor(key) if self.can_leave_out(each)]
            self._change(dict.fromkeys(keys))

    def copy_to_other_motor(self, key: str) -> None:
        """Give the other motor the value that this one has."""
        other_motor, wire = self.other_motor_of(key), self._draft.value(key)
        if other_motor is not None and wire is not None:
            self._change({other_motor: wire})

    def discard_edits(self) -> None:
        """Go back to what is stored; this can be undone."""
        if modified := self.modified:
            self._undo.beginMacro(self.tr("Discard edits"))
            for key in modified:
                self._change({key: self._draft.stored.get(key)})
            self._undo.endMacro()

    def _with_other_motor(self, key: str) -> tuple[str, ...]:
        other_motor = self.other_motor_of(key) if self._both_motors else None
        return (key,) if other_motor is None else (key, other_motor)

    def _change(self, wanted: Mapping[str, int | None]) -> None:
        """Make edits of what would be other values; together one step to undo."""
        before = {key: self._draft.value(key) for key in wanted}
        edits = [
            Edit(self.text.specs[key].name, self._put, key, before[key], wire)
            for key, wire in wanted.items()
            if wire != before[key]
        ]
        if len(edits) == 1:
            self._undo.push(edits[0])
        elif edits:
            key = next(iter(wanted))
            name = self.text.specs[key].name.removeprefix(motor_name(key))
            self._undo.beginMacro(self.tr("Motors 1 and 2{0}").format(name))
            for each in edits:
                self._undo.push(each)
            self._undo.endMacro()

    def _put(self, key: str, wire: int | None) -> None:
        """Put a value in its place; a board that no longer has the parameter is left alone."""
        if self.knows(key):
            if wire is None:
                self._draft.leave_out(key)
            else:
                self._draft.edit(self.text.specs[key], wire)
            self._announce(key)
            self.pending_changed.emit(len(self.modified))

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        spec = self._spec_at(index)
        if spec is None or role != Qt.ItemDataRole.EditRole:
            return False
        if not self.flags(index) & Qt.ItemFlag.ItemIsEditable:
            return False
        try:
            self.edit(spec.key, int(value))
        except BadRequest as error:
            self.rejected.emit(sentence(error))
            return False
        except (TypeError, ValueError, OverflowError):
            self.rejected.emit(f"{spec.name} is {spec.range_text()}, not {value}.")
            return False
        return True
