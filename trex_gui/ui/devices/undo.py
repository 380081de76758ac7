"""Edits as undo commands. Only these commands change the values that wait for Apply.

A change that the device reports is not an edit. A command stores the value that was shown before,
so undoing an edit after it was applied makes the old value a new edit.
"""

from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtGui import QUndoCommand

from trex_gui.core.translation import tr
from trex_gui.ui.widgets.builders import no_mnemonic

KeyT = TypeVar("KeyT")
ValueT = TypeVar("ValueT")


_OF_A_RUN = 1  # command id: Qt may merge commands with the same id, but never with -1


def undo_titles(undone: str, redone: str) -> tuple[str, str]:
    """Return the menu entries of undo and redo, with the texts of their commands if not empty."""
    return (
        tr("&Undo {0}").format(undone) if undone else tr("&Undo"),
        tr("&Redo {0}").format(redone) if redone else tr("&Redo"),
    )


class Edit(QUndoCommand, Generic[KeyT, ValueT]):
    """Command that replaces a value by calling `put` with the key and the new value.

    Consecutive edits of the same key with the same `run` are one undo step.
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
        return -1 if self.run is None else _OF_A_RUN

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Merge the next edit of the run. If it restores the first value, no undo step is left."""
        if not isinstance(other, Edit) or (other.run, other.key) != (self.run, self.key):
            return False
        self.after = other.after
        self.setObsolete(self.after == self._before)
        return True
