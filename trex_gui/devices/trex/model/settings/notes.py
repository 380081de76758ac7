"""Notes of the user on settings of a board or a file."""

from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.core.translation import tr
from trex_gui.devices.trex.settings.notes import LONGEST_NOTE, clean_note
from trex_gui.ui.devices.undo import Edit


class Notes(QObject):
    """A note for each key. Edits use an undo stack, and need no Apply.

    A board cannot store notes. They are saved on this computer, see `BoardMemory`.
    """

    changed = Signal()
    edited = Signal()  # by the user

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self.are_known = False  # whether the notes of this board or file were read
        self._undo = undo or QUndoStack(self)
        self._notes: dict[str, str] = {}
        self._owner: object = None

    @property
    def all(self) -> dict[str, str]:
        return dict(self._notes)

    def of(self, key: str) -> str:
        return self._notes.get(key, "")

    def load(self, notes: Mapping[str, str], owner: object = None) -> None:
        """Load saved notes. Undo affects notes of this owner only."""
        self._notes, self._owner, self.are_known = dict(notes), owner, True
        self.changed.emit()

    def clear(self) -> None:
        """Show no notes until the notes of another board are known."""
        self._notes, self._owner, self.are_known = {}, None, False
        self.changed.emit()

    def edit(self, key: str, text: str, *, name: str = "", run: object = None) -> None:
        """Replace a note. An empty text removes it. Undo shows `name`, the setting's name.

        Consecutive edits of a note with the same `run` are one undo step.
        """
        before, after = self.of(key), clean_note(text)[:LONGEST_NOTE].rstrip()
        if self.are_known and after != before:
            title = tr("Note on {0}").format(name or key)
            self._undo.push(Edit(title, self._put, (self._owner, key), before, after, run=run))

    def _put(self, place: tuple[object, str], text: str) -> None:
        owner, key = place
        if owner != self._owner or not self.are_known:
            return  # the note of another board
        self._notes.pop(key, None)
        if text:
            self._notes[key] = text
        self.changed.emit()
        self.edited.emit()
