"""Files dropped onto a window."""

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QWidget


class FileDrop(QObject):
    """Event filter for dropped files. Qt calls the newest filter of a window first."""

    dropped = Signal(object)  # list of at least one `Path`

    def __init__(self, window: QWidget, accepts: Callable[[Sequence[Path]], bool] = bool) -> None:
        super().__init__(window)
        self._accepts = accepts
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds = {QEvent.Type.DragEnter, QEvent.Type.Drop}
        if event.type() in kinds and isinstance(event, QDropEvent):
            urls = event.mimeData().urls()
            paths = [Path(url.toLocalFile()) for url in urls if url.isLocalFile()]
            if paths and len(paths) == len(urls) and self._accepts(paths):
                event.acceptProposedAction()
                if event.type() == QEvent.Type.Drop:
                    self.dropped.emit(paths)
                return True
        return super().eventFilter(watched, event)
