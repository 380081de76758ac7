"""Edits as commands that can be taken back. They alone change what waits for Apply.

What the device reports by itself is no edit. A command knows the value that was shown before,
so taking an edit back after it was applied makes the old value an edit of its own.
"""

from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtGui import QUndoCommand

from trex_gui.core.translation import tr
from trex_gui.ui.widgets.builders import no_mnemonic

KeyT = TypeVar("KeyT")
ValueT = TypeVar("ValueT")


_OF_A_RUN = 1  # to Qt, commands of one kind may be merged; -1: never


def undo_titles(undone: str, redone: str) -> tuple[str, str]:
    """Return the menu entries of undo and redo, with what they change as far as that is known."""
    return (
        tr("&Undo {0}").format(undone) if undone else tr("&Undo"),
        tr("&Redo {0}").format(redone) if redone else tr("&Redo"),
    )


class Edit(QUndoCommand, Generic[KeyT, ValueT]):
    """One value replaced by another, through a function that puts a value in its place.

    Edits of one place with the same `run`, one right after the other, are one step to undo.
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
        """Take in the next edit of the run. One that leads back to the start leaves no step."""
        if not isinstance(other, Edit) or (other.run, other.key) != (self.run, self.key):
            return False
        self.after = other.after
        self.setObsolete(self.after == self._before)
        return True
