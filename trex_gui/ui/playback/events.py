"""The events of a recording in a list."""

from typing import Any

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.ui.playback.player import RecordingPlayer
from trex_gui.ui.plotting.event_list import EventList, EventModel


class RecordedEvents(EventList):
    """Says of a recording without events that there are none, not that some may come."""

    _player: RecordingPlayer[Any, Any, Any] | None = None

    def __init__(
        self,
        model: EventModel,
        player: RecordingPlayer[Any, Any, Any],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(model, parent)
        self._player = player
        player.loaded.connect(self._on_loaded)
        self._describe()

    @property
    def empty_text(self) -> str:
        """What is said in place of events; empty when there are some, or while they are read."""
        player = self._player
        if player is None or not player.is_loaded or player.events:
            return ""
        return self.tr("Nothing happened in this recording that is listed here.")

    @Slot()
    def _on_loaded(self) -> None:
        self._describe()
        self.viewport().update()
