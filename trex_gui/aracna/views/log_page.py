"""What happened to the robot, newest first."""

import time

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QListWidget, QVBoxLayout, QWidget

from trex_gui.model.events import Event, EventKind, Events
from trex_gui.views.icons import icon

_MOST = 500


class LogPage(QWidget):
    """A list of sentences with the times at which they were true."""

    def __init__(self, events: Events, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaLogPage")
        self._list = QListWidget(self)
        self._list.setObjectName("aracnaLog")
        self._list.setAccessibleName(self.tr("What happened"))
        self._list.setWordWrap(True)
        self._list.setAlternatingRowColors(True)

        layout = QVBoxLayout(self)
        layout.addWidget(self._list)

        events.happened.connect(self._on_happened)
        for event in events.all[-_MOST:]:
            self._on_happened(event)

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        wall = time.time() - (time.monotonic() - event.time)
        moment = time.strftime("%H:%M:%S", time.localtime(wall))
        self._list.insertItem(0, f"{moment}  {event.text}")
        item = self._list.item(0)
        if event.kind is EventKind.FAULT:
            item.setIcon(icon("warning", "warning"))
        while self._list.count() > _MOST:
            self._list.takeItem(self._list.count() - 1)
