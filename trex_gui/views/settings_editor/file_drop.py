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
            path = _one_file(event)
            if path is not None and path.suffix.lower() in self._suffixes:
                event.acceptProposedAction()
                if event.type() == QEvent.Type.Drop:
                    self.dropped.emit(path)
                return True
        return super().eventFilter(watched, event)


def _one_file(event: QDropEvent) -> Path | None:
    """Return the one file that is dragged, if it is that."""
    urls = event.mimeData().urls()
    if len(urls) != 1 or not urls[0].isLocalFile():
        return None
    return Path(urls[0].toLocalFile())
