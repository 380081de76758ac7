"""Saving a document that the user edits, while its window goes on."""

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
        """Content of its file when it was opened or saved."""

    @property
    def modified(self) -> bool:
        """Return whether it has changes that are not in the file."""


@dataclass(slots=True)
class _Following:
    """A save that waits for another one in the same file. What `known` means is in `_start`."""

    content: Content
    known: bytes | None


class DocumentSaver(QObject):
    """Saves a document in the background, and asks before changes are lost.

    What is edited meanwhile stays unsaved. A second save in the same file follows the first; one in
    another file does not wait, since the first may be on a disk that hangs.
    """

    saved = Signal(object)  # the `Path`
    failed = Signal(object)  # the `StudioError` that prevented it

    def __init__(self, document: Document, window: QWidget) -> None:
        super().__init__(window)
        self._document = document
        self._window = window
        self._running: dict[Path, list[_Following]] = {}
        self._begun = self._noted = 0  # numbers of saves
        self._leave: Callable[[], object] | None = None

    @property
    def is_saving(self) -> bool:
        return bool(self._running)

    def save(self, path: Path, make: Callable[[], Content], *, ask: bool = False) -> bool:
        """Begin to save what `make` returns now and return whether that has begun.

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
        """Save in a file that should hold what is `known`. `None`: whatever it holds."""
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
            if number > self._noted:  # else it was overtaken
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
        """Ask what to do with changes that are not saved. Without any, they are discarded."""
        if self.is_saving:
            may = file_questions.may_leave_unfinished(self._window, self._document.name)
            return SaveAnswer.DISCARD if may else SaveAnswer.CANCEL
        if not self._document.modified:
            return SaveAnswer.DISCARD
        return file_questions.before_closing(self._window, self._document.name)

    def save_and_leave(self, save: Callable[[], bool], leave: Callable[[], object]) -> None:
        """Call `leave` once `save` has begun a save and that has ended well."""
        if save():
            self._leave = leave
