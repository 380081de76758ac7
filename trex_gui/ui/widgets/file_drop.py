"""Files that are dropped onto a window."""

from collections.abc import Collection
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QWidget

TEXT = frozenset({".txt", ".yaml", ".yml"})
"""How names of settings files end."""


class FileDrop(QObject):
    """Takes files of some kinds for its window; anything else is not for us.

    Signals:
        dropped: the `Path` of a file.
    """

    dropped = Signal(object)

    def __init__(self, window: QWidget, suffixes: Collection[str] = TEXT) -> None:
        super().__init__(window)
        self._suffixes = suffixes
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds = {QEvent.Type.DragEnter, QEvent.Type.Drop}
        if event.type() in kinds and isinstance(event, QDropEvent):
            paths = _files(event)
            if len(paths) == 1 and paths[0].suffix.lower() in self._suffixes:
                event.acceptProposedAction()
                if event.type() == QEvent.Type.Drop:
                    self.dropped.emit(paths[0])
                return True
        return super().eventFilter(watched, event)


class AnyFileDrop(QObject):
    """Takes every dropped file that no other widget takes, so that none is ignored silently.

    Create it before other event filters: Qt calls the last one first.

    Signals:
        dropped: a tuple of `Path`s, at least one.
    """

    dropped = Signal(object)

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds = {QEvent.Type.DragEnter, QEvent.Type.Drop}
        if event.type() in kinds and isinstance(event, QDropEvent) and (paths := _files(event)):
            event.acceptProposedAction()
            if event.type() == QEvent.Type.Drop:
                self.dropped.emit(paths)
            return True
        return super().eventFilter(watched, event)


def _files(event: QDropEvent) -> tuple[Path, ...]:
    """Return the files that are dragged; none where anything else is among them."""
    urls = event.mimeData().urls()
    if not all(url.isLocalFile() for url in urls):
        return ()
    return tuple(Path(url.toLocalFile()) for url in urls)
