"""What a gamepad shows now: a bar an axis, a lamp a button."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QGroupBox, QLabel, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.driving.gamepad_text import GamepadWords
from trex_gui.devices.trex.views.driving.gamepad_bar import PartBar
from trex_gui.gamepad.pads import Pad, PadState
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.leds import Lamp

_LAMPS_A_ROW = 6


class GamepadLive(QGroupBox):
    """Made for one gamepad; made anew for another."""

    def __init__(self, words: GamepadWords, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("gamepadLive")
        self.setTitle(self.tr("What the gamepad shows"))
        self._words = words
        self._pad: Pad | None = None
        self._content = QWidget(self)
        self._bars: list[PartBar] = []
        self._lamps: list[Lamp] = []

        ui.column(self._content, 1, into=self)

    def show_pad(self, pad: Pad | None) -> None:
        """Make room for the parts of this gamepad."""
        if pad == self._pad:
            return
        self._pad = pad
        old, self._content = self._content, QWidget(self)
        box = self.layout()
        if box is not None:
            box.replaceWidget(old, self._content)
        old.hide()
        old.deleteLater()
        self._bars, self._lamps = [], []
        layout = QVBoxLayout(self._content)
        layout.setContentsMargins(0, 0, 0, 0)
        if pad is not None:
            layout.addLayout(self._axes(pad))
            layout.addSpacing(8)
            layout.addLayout(self._buttons(pad))
        self._content.show()

    def show_state(self, state: PadState | None) -> None:
        """Show how it stands."""
        for number, bar in enumerate(self._bars):
            bar.set_part(None if state is None else state.axis(number))
        for number, lamp in enumerate(self._lamps):
            down = state is not None and state.pressed(number)
            if down != lamp.lit:
                lamp.set_lit(down)
                lamp.setAccessibleDescription(self.tr("pressed") if down else "")

    def _axes(self, pad: Pad) -> QGridLayout:
        grid = QGridLayout()
        grid.setColumnStretch(1, 1)
        for number in range(pad.axes):
            name = self._words.axis(pad, number)
            label = QLabel(name, self._content)
            bar = ui.named(PartBar("", self._content), f"gamepadAxisBar{number}", accessible=name)
            bar.setMinimumWidth(18 * bar.fontMetrics().averageCharWidth())
            grid.addWidget(label, number, 0)
            grid.addWidget(bar, number, 1)
            self._bars.append(bar)
        return grid

    def _buttons(self, pad: Pad) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        for number in range(pad.buttons):
            name = self._words.button(pad, number)
            lamp = ui.named(
                Lamp("led_green", self._content), f"gamepadLamp{number}", accessible=name
            )
            label = QLabel(str(number + 1), self._content)
            for widget in (lamp, label):
                widget.setToolTip(name)
            cell = ui.row(lamp, (label, 1), spacing=4)
            grid.addLayout(cell, number // _LAMPS_A_ROW, number % _LAMPS_A_ROW)
            self._lamps.append(lamp)
        grid.setAlignment(Qt.AlignmentFlag.AlignLeft)
        return grid
