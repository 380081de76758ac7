"""What protects a robot when this program cannot: said where motors are armed, set with a click."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QWidget

from trex_gui.model.device import Device
from trex_gui.views.theme import theme

_OFFERED_S = 0.5
"""Seconds offered: a robot at 2 m/s goes a metre, and no line that works is silent for so long."""


class TimeoutNotice(QWidget):
    """One line while the board's serial timeout is off; not there at all otherwise."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("timeoutNotice")
        self._device = device

        self._text = QLabel(
            self.tr(
                "Serial timeout is off: motors go on turning if the cable, this computer or this "
                "program fails."
            ),
            self,
        )
        self._text.setObjectName("timeoutLabel")
        self._text.setWordWrap(True)
        self._button = QPushButton(self.tr("Set {0} s").format(_OFFERED_S), self)
        self._button.setObjectName("timeoutButton")
        self._button.setAccessibleName(
            self.tr("Set the serial timeout to {0} seconds").format(_OFFERED_S)
        )
        self._button.setToolTip(
            self.tr(
                "Writes this one setting into the board now: it then stops its motors {0} s after "
                "the last byte. Other changes go on waiting for Apply."
            ).format(_OFFERED_S)
        )
        self._button.setFlat(True)
        self._button.setCursor(QCursor(Qt.CursorShape.PointingHandCursor))
        font = self._button.font()
        font.setUnderline(True)
        self._button.setFont(font)

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._text, 1)
        layout.addWidget(self._button)

        self._button.clicked.connect(self._on_clicked)
        device.link_changed.connect(self._on_changed)
        device.state_changed.connect(self._on_changed)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        self.setVisible(self._device.timeout_off)
        self._button.setEnabled(not self._device.applying)

    @Slot()
    def _on_clicked(self) -> None:
        self._device.set_serial_timeout(_OFFERED_S)

    @Slot()
    def _on_theme_changed(self) -> None:
        for widget, name in ((self._text, "warning"), (self._button, "link")):
            palette = self.palette()
            palette.setColor(widget.foregroundRole(), theme().color(name))
            widget.setPalette(palette)
