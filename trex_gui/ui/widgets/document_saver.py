"""Background saving of a document while the user edits it."""

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
        """True if the document has unsaved changes."""


@dataclass(slots=True)
class _QueuedSave:
    content: Content
    expected: bytes | None


class DocumentSaver(QObject):
    """Saves a document in the background. Asks the user before changes are lost.

    Edits made during a save remain unsaved. A second save of a file waits for the first. A save to
    another file does not wait, because a disk may hang.
    """

    saved = Signal(object)  # `Path` of the saved file
    failed = Signal(object)  # `StudioError` that prevented a save

    def __init__(self, document: Document, window: QWidget) -> None:
        super().__init__(window)
        self._document = document
        self._window = window
        self._running: dict[Path, list[_QueuedSave]] = {}  # path being saved → queued saves
        self._last_started = self._last_recorded = 0  # numbers of saves
        self._leave: Callable[[], object] | None = None

    def save(self, path: Path, create: Callable[[], Content], *, ask: bool = False) -> bool:
        """Save the content that `create` returns. Return False if `create` fails.

        If `create` raises a `StudioError`, `failed` is emitted. `ask`: ask the user before
        overwriting changes that another program made in the file.
        """
        try:
            content = create()
        except StudioError as error:
            self._leave = None
            self.failed.emit(error)
            return False
        self._start(path, content, self._document.on_disk if ask else None)
        return True

    def _start(self, path: Path, content: Content, expected: bytes | None) -> None:
        """Save if the file still contains `expected`. `None`: overwrite any content."""
        if path in self._running:
            self._running[path].append(_QueuedSave(content, expected))
            return
        self._last_started += 1
        self._running[path] = []
        in_background(
            self,
            partial(save_over, path, content.text, expected),
            partial(self._on_ended, path, content, self._last_started),
            partial(self._on_failed, path),
        )

    def _on_ended(self, path: Path, content: Content, number: int, is_written: bool) -> None:
        if is_written:
            written = content.text.encode("utf-8")
            for queued in self._running[path]:
                queued.expected = None if queued.expected is None else written
            if number > self._last_recorded:  # otherwise a later save has already ended
                self._last_recorded = number
                content.record_saved(path)
            self.saved.emit(path)
        elif file_questions.may_overwrite(self._window, path.name):
            self._running[path].insert(0, _QueuedSave(content, None))
        else:
            self._leave = None
        self._start_queued(path)

    def _on_failed(self, path: Path, error: StudioError) -> None:
        self._leave = None
        self.failed.emit(error)
        self._start_queued(path)

    def _start_queued(self, path: Path) -> None:
        for queued in self._running.pop(path):
            self._start(path, queued.content, queued.expected)
        if not self._running and self._leave is not None:
            leave, self._leave = self._leave, None
            leave()

    def may_leave(
        self, answer: SaveAnswer, save: Callable[[], bool], leave: Callable[[], object]
    ) -> bool:
        """Return whether the user may leave the document. On `SAVE`, save it, then call `leave`."""
        if answer is SaveAnswer.SAVE:
            self.save_and_leave(save, leave)
        return answer is SaveAnswer.DISCARD

    def answer(self) -> SaveAnswer:
        """Ask the user about unsaved changes. Return `DISCARD` if there are none."""
        if self._running:
            may_leave = file_questions.may_leave_unfinished(self._window, self._document.name)
            return SaveAnswer.DISCARD if may_leave else SaveAnswer.CANCEL
        if not self._document.modified:
            return SaveAnswer.DISCARD
        return file_questions.prompt_about_changes(self._window, self._document.name)

    def save_and_leave(self, save: Callable[[], bool], leave: Callable[[], object]) -> None:
        """Call `save`. Call `leave` once every running save has succeeded."""
        if save():
            self._leave = leave
