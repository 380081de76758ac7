"""Field for the note on a setting."""

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtGui import QFocusEvent
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.draft import Notes
from trex_gui.devices.trex.settings.notes import clean_note
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets.builders import named


class NoteField(QPlainTextEdit):
    """Editor for the note on a setting. Uninterrupted typing is one undo step."""

    def __init__(self, notes: Notes, name: str, parent: QWidget, *, lines: int = 3) -> None:
        super().__init__(parent)
        self._notes = notes
        self._lines = lines
        self._key = self._name = ""
        self._undo_step = object()
        named(self, name, accessible=tr("Note"))
        self.setTabChangesFocus(True)
        hint = tr("Why this value? Saved on this computer and in files.")
        if lines > 1:
            self.setPlaceholderText(hint)
        else:
            self.setPlaceholderText(tr("Note"))
            self.setToolTip(hint)
            self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
            self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
            self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        follow_theme(self, "height", self._fit)
        self.textChanged.connect(self._on_typed)
        notes.changed.connect(self._refresh)
        self._refresh()

    def _fit(self) -> None:
        frame = 2 * (self.frameWidth() + round(self.document().documentMargin()))
        self.setFixedHeight(self._lines * self.fontMetrics().lineSpacing() + frame)

    def show_note_on(self, key: str, name: str) -> None:
        """Show the note on a setting. An empty key disables the field."""
        if key != self._key:
            self._undo_step = object()
        self._key, self._name = key, name
        self.setAccessibleName(tr("Note on {0}").format(name) if key else tr("Note"))
        self._refresh()

    @Slot()
    def _refresh(self) -> None:
        self.setEnabled(bool(self._key) and self._notes.are_known)
        note = self._notes.of(self._key)
        if clean_note(self.toPlainText()) != note:
            with QSignalBlocker(self):
                self.setPlainText(note)

    @Slot()
    def _on_typed(self) -> None:
        self._notes.edit(self._key, self.toPlainText(), name=self._name, run=self._undo_step)
        self._refresh()  # shows the saved part of a note that is too long

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self._undo_step = object()
