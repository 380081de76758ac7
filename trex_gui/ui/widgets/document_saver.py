"""Background saving of a document that the user goes on editing."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Protocol

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.files import save_over
from trex_gui.ui.files import Content, in_background
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.file_questions import SaveAnswer


class Document(Protocol):
    @property
    def name(self) -> str: ...

    @property
    def on_disk(self) -> bytes | None:
        """Content of the file when the document was last opened or saved."""

    @property
    def modified(self) -> bool:
        """Return whether the document has changes that are not in the file."""


@dataclass(slots=True)
class _Following:
    """A save that waits for an earlier save of the same file. `_start` explains `known`."""

    content: Content
    known: bytes | None


class DocumentSaver(QObject):
    """Saves a document in the background, and asks before changes are lost.

    Edits made meanwhile stay unsaved. A second save of the same file waits for the first. A save to
    another file does not wait, since the first may be on a disk that hangs.
    """

    saved = Signal(object)  # the `Path`
    failed = Signal(object)  # the `StudioError` that prevented a save

    def __init__(self, document: Document, window: QWidget) -> None:
        super().__init__(window)
        self._document = document
        self._window = window
        self._running: dict[Path, list[_Following]] = {}
        self._begun = self._noted = 0  # numbers of the last save started, and recorded
        self._leave: Callable[[], object] | None = None

    def save(self, path: Path, make: Callable[[], Content], *, ask: bool = False) -> bool:
        """Save the content that `make` returns now. Return whether the save was requested.

        If `make` raises a StudioError, `failed` reports it. With `ask`, the user decides about
        changes that another program made in the file.
        """
        try:
            content = make()
        except StudioError as error:
            self._leave = None
            self.failed.emit(error)
            return False
        self._start(path, content, self._document.on_disk if ask else None)
        return True

    def _start(self, path: Path, content: Content, known: bytes | None) -> None:
        """Save to a file that should still contain `known`. With `None`, overwrite any content."""
        if path in self._running:
            self._running[path].append(_Following(content, known))
            return
        self._begun += 1
        self._running[path] = []
        in_background(
            self,
            partial(save_over, path, content.text, known),
            partial(self._on_ended, path, content, self._begun),
            partial(self._on_failed, path),
        )

    def _on_ended(self, path: Path, content: Content, number: int, is_written: bool) -> None:
        if is_written:
            written = content.text.encode("utf-8")
            for following in self._running[path]:
                following.known = None if following.known is None else written
            if number > self._noted:  # else a later save finished first
                self._noted = number
                content.record_saved(path)
            self.saved.emit(path)
        elif file_questions.may_overwrite(self._window, path.name):
            self._running[path].insert(0, _Following(content, None))
        else:
            self._leave = None
        self._go_on(path)

    def _on_failed(self, path: Path, error: StudioError) -> None:
        self._leave = None
        self.failed.emit(error)
        self._go_on(path)

    def _go_on(self, path: Path) -> None:
        for following in self._running.pop(path):
            self._start(path, following.content, following.known)
        if not self._running and self._leave is not None:
            leave, self._leave = self._leave, None
            leave()

    def may_leave(
        self, answer: SaveAnswer, save: Callable[[], bool], leave: Callable[[], object]
    ) -> bool:
        """Return whether the document may be left. With `SAVE`, call `leave` once it is saved."""
        if answer is SaveAnswer.SAVE:
            self.save_and_leave(save, leave)
        return answer is SaveAnswer.DISCARD

    def answer(self) -> SaveAnswer:
        """Ask what to do with unsaved changes. Return `DISCARD` if there are none."""
        if self._running:
            may = file_questions.may_leave_unfinished(self._window, self._document.name)
            return SaveAnswer.DISCARD if may else SaveAnswer.CANCEL
        if not self._document.modified:
            return SaveAnswer.DISCARD
        return file_questions.before_closing(self._window, self._document.name)

    def save_and_leave(self, save: Callable[[], bool], leave: Callable[[], object]) -> None:
        """Call `save`, then call `leave` once every running save has succeeded."""
        if save():
            self._leave = leave
