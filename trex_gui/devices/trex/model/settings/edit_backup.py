"""Edits that were made for a board of another kind: they are kept as a snapshot."""

from PySide6.QtCore import QObject, Slot

from trex_gui.core.errors import sentence
from trex_gui.core.files.errors import SettingsError
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.ui.notifier import Notifier


class EditBackup(QObject):
    """Saves what a draft shows before the settings of another kind replace it."""

    def __init__(
        self, history: SettingsHistory, notifier: Notifier, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._history = history

    @Slot(object)
    def keep(self, shown: Settings) -> None:
        """Save settings with edits that no board of their kind is there for any more."""
        name = f"{shown.product.name} {shown.firmware or ''}".strip()
        reason = self.tr("another board; with edits that were not applied")
        try:
            self._history.take(shown, adapter="", reason=reason)
        except SettingsError as error:
            text = self.tr("The edits for the {0} before could not be saved. {1}")
            self._notifier.error.emit(text.format(name, sentence(error)))
            return
        text = self.tr(
            "The settings of the {0} before, with the edits that were not applied, are kept in "
            "File, History."
        )
        self._notifier.delayed_info.emit(text.format(name))
