"""Edits as commands that can be taken back; they alone change what waits for Apply.

What the device reports by itself is no edit. A command knows the value that was shown before,
so taking an edit back after it was applied makes the old value an edit of its own.
"""

from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtGui import QUndoCommand

KeyT = TypeVar("KeyT")
ValueT = TypeVar("ValueT")


class Edit(QUndoCommand, Generic[KeyT, ValueT]):
    """One value replaced by another, through a function that puts a value in its place."""

    def __init__(
        self,
        text: str,
        put: Callable[[KeyT, ValueT], None],
        key: KeyT,
        before: ValueT,
        after: ValueT,
    ) -> None:
        super().__init__(text)
        self._put = put
        self._key = key
        self._before = before
        self._after = after

    def redo(self) -> None:
        self._put(self._key, self._after)

    def undo(self) -> None:
        self._put(self._key, self._before)
