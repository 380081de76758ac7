"""What a new settings file begins with."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QWidget,
)

from trex_gui.core.errors import StudioError, sentence
from trex_gui.core.files import load
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.labels import Note


class NewDialog(QDialog):
    """A list of beginnings, the newest firmware first.

    Signals:
        made: the new `SettingsDocument`.
    """

    made = Signal(object)

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("newSettingsDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(self.tr("New settings file"))
        self.resize(620, 440)
        self._device = device
        self._makers: list[Callable[[], SettingsDocument]] = []

        about = QLabel(self.tr("Start the new file with:"), self)
        self._list = QListWidget(self)
        self._list.setObjectName("beginningsList")
        self._list.setAccessibleName(about.text())
        self._list.setAlternatingRowColors(True)
        self._list.setSpacing(2)
        self._trouble = Note(1, self)
        self._trouble.hide()
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel, self
        )
        self._fill()

        column(about, (self._list, 1), self._trouble, buttons, into=self)

        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.close)
        self._list.itemActivated.connect(self.accept)

    def _fill(self) -> None:
        shown = self._device.draft.shown if self._device.state is not None else None
        if shown is not None:
            words = self.tr("The board as shown: {0}, firmware {1}").format(
                shown.product.name, shown.firmware
            )
            self._add(words, self._from_board)
        for model in device_table().models:
            for firmware in reversed(model.firmware):
                words = self.tr("Factory values of a {0}, firmware {1}").format(
                    model.name, firmware
                )
                self._add(words, self._from_factory(model.key, firmware))
        for path in sorted(resource("samples").glob("*.txt")):
            if not path.stem.endswith("factory_defaults"):
                words = self.tr("Sample: {0}").format(_title(path))
                self._add(words, self._from_sample(path))
        self._list.setCurrentRow(0)

    def _add(self, words: str, make: Callable[[], SettingsDocument]) -> None:
        item = QListWidgetItem(words, self._list)
        item.setToolTip(words)
        self._makers.append(make)

    def _from_board(self) -> SettingsDocument:
        shown = self._device.draft.shown
        if shown is None:
            raise StudioError(self.tr("no board is connected any more"))
        name = f"{shown.product.key}_settings.txt"
        title = self.tr("As a board showed them.")
        return SettingsDocument.of_settings(shown, name, title=title)

    def _from_factory(self, key: str, firmware: str) -> Callable[[], SettingsDocument]:
        def make() -> SettingsDocument:
            settings = factory_settings(device_table().model(key), firmware)
            title = self.tr("As from the factory.")
            return SettingsDocument.of_settings(settings, f"{key}_settings.txt", title=title)

        return make

    @staticmethod
    def _from_sample(path: Path) -> Callable[[], SettingsDocument]:
        return lambda: SettingsDocument(load(path).decode("utf-8"), path.name)

    @Slot()
    def accept(self) -> None:
        """Make what is chosen."""
        row = self._list.currentRow()
        if row < 0:
            return
        try:
            document = self._makers[row]()
        except StudioError as error:
            self._trouble.show_note(sentence(error), alarming=True)
            self._trouble.show()
            return
        self.made.emit(document)
        super().accept()


def _title(path: Path) -> str:
    """Return the first comment of a sample, which says what it is for."""
    lines = path.read_text(encoding="utf-8").splitlines()
    comments = (line.removeprefix("#").strip() for line in lines if line.startswith("# "))
    return next(comments, path.stem).rstrip(".")
