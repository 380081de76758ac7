"""Undo commands for edits.

A change that the device reports is not an edit. A command stores the previous value. Therefore,
undoing an applied edit makes the previous value a new edit.
"""

from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtGui import QUndoCommand

from trex_gui.core.translation import tr
from trex_gui.ui.widgets.builders import no_mnemonic

KeyT = TypeVar("KeyT")
ValueT = TypeVar("ValueT")

_RUN_ID = 1  # Qt may merge commands with equal ids, but never with the id -1


def undo_titles(undone: str, redone: str) -> tuple[str, str]:
    """Return the menu texts of undo and redo.

    `undone`: text of the command to undo. `redone`: text of the command to redo.
    """
    return (
        tr("&Undo {0}").format(undone) if undone else tr("&Undo"),
        tr("&Redo {0}").format(redone) if redone else tr("&Redo"),
    )


class Edit(QUndoCommand, Generic[KeyT, ValueT]):
    """Command that sets a value by calling `put` with the key and the value.

    Consecutive edits with the same key and `run` form one undo step.
    """

    def __init__(
        self,
        text: str,
        put: Callable[[KeyT, ValueT], None],
        key: KeyT,
        before: ValueT,
        after: ValueT,
        *,
        run: object = None,
    ) -> None:
        super().__init__(no_mnemonic(text))
        self._put = put
        self.key = key
        self._before = before
        self.after = after
        self.run = run

    def redo(self) -> None:
        self._put(self.key, self.after)

    def undo(self) -> None:
        self._put(self.key, self._before)

    def id(self) -> int:
        return -1 if self.run is None else _RUN_ID

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Merge the next edit of the run. If the edit restores the first value, remove the step."""
        if not isinstance(other, Edit) or (other.run, other.key) != (self.run, self.key):
            return False
        self.after = other.after
        self.setObsolete(self.after == self._before)
        return True
