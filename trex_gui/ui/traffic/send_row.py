"""Input field for bytes to send, with a preview of their meaning."""

from dataclasses import dataclass

from PySide6.QtCore import QObject, Qt, Signal, Slot
from PySide6.QtWidgets import QLineEdit, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note, Sign


@dataclass(frozen=True, slots=True)
class SendPreview:
    text: str = ""  # meaning of the bytes; empty if the input has no bytes
    blocker: str = ""  # reason why the bytes cannot be sent; empty if they can be sent
    is_risky: bool = False  # True if the bytes may start a motor or change stored values
    details: str = ""  # full text for a tool tip if `text` is shortened


class PacketSender(QObject):
    """Interprets and sends bytes that the user typed."""

    changed = Signal()  # `preview` may return another result

    hint = ""  # example input

    def preview(self, text: str) -> SendPreview:
        raise NotImplementedError

    def send(self, text: str) -> None:
        """Send the bytes and report the result. The preview of `text` must have no blocker."""
        raise NotImplementedError


class SendRow(QWidget):
    def __init__(self, sender: PacketSender, key: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._sender = sender
        self._field = ui.named(QLineEdit(self), f"{key}Bytes")
        self._field.setPlaceholderText(sender.hint)
        self._field.setClearButtonEnabled(True)
        label = ui.label(self, text=tr("Bytes t&o send:"), buddy=self._field)
        self._sign = Sign(self)
        self._meaning = ui.named(Note(2, self), f"{key}Meaning")
        self._meaning.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        text, tip = tr("Send &bytes"), tr("Send these bytes unchanged (Enter)")
        self._button = ui.button(
            self, f"{key}SendButton", text, icon="console", tip=tip, on_click=self._send
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
        if preview.is_risky:
            self._sign.show_sign("warning", "warning")
        elif preview.blocker and not preview.text:
            self._sign.show_sign("error", "danger")
        else:
            self._sign.show_sign("")
        self._meaning.show_note("\n".join(filter(None, (preview.text, preview.blocker))))
        self._meaning.setToolTip(ui.plain(preview.details))
        self._button.setEnabled(bool(preview.text) and not preview.blocker)

    @Slot()
    def _send(self) -> None:
        self._sender.send(self._field.text())
        self._field.selectAll()
