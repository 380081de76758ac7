"""Sending bytes that the user types, with their meaning shown before they go."""

from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import SignalInstance, Slot
from PySide6.QtWidgets import QLineEdit, QWidget

from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note, Sign


@dataclass(frozen=True, slots=True)
class SendPreview:
    """What typed bytes mean.

    Attributes:
        text: for the user; empty if nothing was typed.
        blocker: why they cannot be sent now, for the user; empty if they can.
        is_risky: whether they move something or change what is stored.
    """

    text: str = ""
    blocker: str = ""
    is_risky: bool = False


class PacketSender(Protocol):
    """What knows what bytes mean, and sends them."""

    @property
    def changed(self) -> SignalInstance:
        """Emitted when a preview may be different now."""
        ...

    @property
    def hint(self) -> str:
        """An example of what can be typed."""
        ...

    def preview(self, text: str) -> SendPreview: ...
    def send(self, text: str) -> None:
        """Send what has a preview without a blocker; the result goes to the notifier."""


class SendRow(QWidget):
    """A field for bytes, what they mean, and a button that sends them."""

    def __init__(self, sender: PacketSender, key: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._sender = sender
        self._field = ui.named(QLineEdit(self), f"{key}Bytes", accessible=self.tr("Bytes to send"))
        self._field.setPlaceholderText(sender.hint)
        self._field.setClearButtonEnabled(True)
        label = ui.label(self, text=self.tr("Bytes t&o send:"), buddy=self._field)
        self._sign = Sign(self)
        self._meaning = ui.named(Note(1, self), f"{key}Meaning")
        self._button = ui.button(
            self,
            f"{key}SendButton",
            self.tr("Send &bytes"),
            icon="console",
            tip=self.tr("Send these bytes as they are (Enter)"),
            on_click=self._send,
        )
        sign_and_meaning = ui.row(self._sign, (self._meaning, 1))
        ui.row(label, (self._field, 2), self._button, (sign_and_meaning, 4), into=self, margins=0)
        self._field.textChanged.connect(self._refresh)
        self._field.returnPressed.connect(self._button.click)
        sender.changed.connect(self._refresh)
        self._refresh()

    @Slot()
    def _refresh(self) -> None:
        preview = self._sender.preview(self._field.text())
        self._sign.show_sign("warning" if preview.is_risky else "", "warning")
        self._meaning.show_note("\n".join(filter(None, (preview.text, preview.blocker))))
        self._button.setEnabled(bool(preview.text) and not preview.blocker)

    @Slot()
    def _send(self) -> None:
        self._sender.send(self._field.text())
        self._field.selectAll()
