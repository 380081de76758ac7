"""What protects a robot when this program cannot: said where motors are armed, set with a click."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.driving.timeout import Weakness, weakness_of_timeout
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui


class TimeoutNotice(QWidget):
    """One line while the serial timeout is off or too short; not there at all otherwise."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("timeoutNotice")
        self._device = device

        self._weakness: Weakness | None = None

        self._text = ui.label(self, "timeoutLabel", wrap=True)
        self._button = ui.button(
            self,
            "timeoutButton",
            accessible=self.tr("Set the serial timeout"),
            on_click=self._on_clicked,
        )
        self._button.setFlat(True)
        self._button.setCursor(QCursor(Qt.CursorShape.PointingHandCursor))
        font = self._button.font()
        font.setUnderline(True)
        self._button.setFont(font)

        ui.row((self._text, 1), self._button, into=self, margins=0)

        device.link_changed.connect(self._on_changed)
        device.state_changed.connect(self._on_changed)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        weakness = weakness_of_timeout(self._device)
        if weakness is not None and weakness != self._weakness:
            self._show(weakness)
        self._weakness = weakness
        self.setVisible(weakness is not None)
        self._button.setEnabled(not self._device.applying)

    def _show(self, weakness: Weakness) -> None:
        seconds = f"{weakness.seconds:g}"
        self._text.setText(weakness.text)
        self._button.setText(self.tr("Set {0} s").format(seconds))
        self._button.setAccessibleName(
            self.tr("Set the serial timeout to {0} seconds").format(seconds)
        )
        self._button.setToolTip(
            self.tr(
                "Writes this one setting into the board now: it then stops its motors {0} s after "
                "the last byte. Other changes go on waiting for Apply."
            ).format(seconds)
        )

    @Slot()
    def _on_clicked(self) -> None:
        if self._weakness is not None:
            self._device.set_serial_timeout(self._weakness.seconds)

    @Slot()
    def _on_theme_changed(self) -> None:
        for widget, name in ((self._text, "warning"), (self._button, "link")):
            palette = self.palette()
            palette.setColor(widget.foregroundRole(), theme().color(name))
            widget.setPalette(palette)
