"""Parts of the gamepad dialog: live bars and lamps, and rows to choose a part."""

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QGridLayout, QGroupBox, QLabel, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.gamepad import axis_text, button_text
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.bars import OutputBar
from trex_gui.gamepad.pads import Pad, PadState
from trex_gui.gamepad.profile import Axis
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import with_sign
from trex_gui.ui.widgets.builders import NoWheelComboBox
from trex_gui.ui.widgets.leds import Lamp


class PartBar(OutputBar):
    """Shows -1 to 1 from the centre; nothing is shown while nothing is read."""

    def __init__(self, label: str, parent: QWidget | None = None) -> None:
        super().__init__(parent, label=label)

    def set_part(self, part: float | None) -> None:
        """Show a part of the way to an end."""
        self.set_connected(part is not None)
        if part is not None:
            self.set_value(round(part * FULL_SCALE))

    def _value_text(self) -> str:
        value = self.value
        return "" if value is None else f"{with_sign(round(100 * value / FULL_SCALE))} %"

    def _spoken_value(self) -> str:
        return self._value_text()

    def _widest_value(self) -> str:
        return f"{with_sign(-100)} %"


_LAMPS_A_ROW = 6


class GamepadLive(QGroupBox):
    """Made for one gamepad; made anew for another."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("gamepadLive")
        self.setTitle(self.tr("What the gamepad shows"))
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
            name = axis_text(pad, number)
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
            name = button_text(pad, number)
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


class PartRow(QWidget):
    """A list of parts and a button to find one by moving or pressing it.

    Signals:
        chosen: the user chose another part, or its direction.
        detect_toggled: whether what is moved now is the part that is meant.
    """

    chosen = Signal()
    detect_toggled = Signal(bool)

    def __init__(
        self, name: str, spoken: str, detect: str, parent: QWidget, *, inverts: bool = False
    ) -> None:
        super().__init__(parent)
        self._combo = NoWheelComboBox(self)
        self._combo.setObjectName(f"gamepad{name}Combo")
        self._combo.setSizeAdjustPolicy(NoWheelComboBox.SizeAdjustPolicy.AdjustToContents)
        self._detect = ui.button(
            self, f"gamepad{name}Detect", detect, checkable=True, default=False
        )
        self._invert = ui.check_box(self, f"gamepad{name}Invert", self.tr("Invert"))
        self._invert.setVisible(inverts)
        self.setFocusProxy(self._combo)
        self.set_spoken(spoken)

        ui.row((self._combo, 1), self._detect, self._invert, into=self, margins=0)

        self._combo.activated.connect(self._on_chosen)
        self._invert.toggled.connect(self._on_chosen)
        self._detect.toggled.connect(self.detect_toggled)

    def set_spoken(self, spoken: str) -> None:
        """Say to screen readers what the part is for."""
        self._combo.setAccessibleName(spoken)
        self._detect.setAccessibleName(self.tr("{0}: find it by moving it").format(spoken))
        self._invert.setAccessibleName(self.tr("{0}: inverted").format(spoken))

    def set_parts(self, parts: list[tuple[str, int | None]]) -> None:
        """List these parts: their names and numbers."""
        listed = [
            (self._combo.itemText(row), self._combo.itemData(row))
            for row in range(self._combo.count())
        ]
        if listed != parts:
            self._combo.clear()
            for text, number in parts:
                self._combo.addItem(text, number)

    @property
    def number(self) -> int | None:
        """The part that is chosen."""
        number = self._combo.currentData()
        return number if isinstance(number, int) else None

    @property
    def axis(self) -> Axis:
        """The axis that is chosen, and its direction."""
        return Axis(self.number or 0, self._invert.isChecked())

    def show_part(self, number: int | None, *, inverted: bool = False) -> None:
        """Show what is chosen; nothing is announced."""
        found = [self._combo.itemData(row) for row in range(self._combo.count())]
        self._combo.setCurrentIndex(found.index(number) if number in found else -1)
        with QSignalBlocker(self._invert):
            self._invert.setChecked(inverted)

    def show_detecting(self, *, detecting: bool) -> None:
        """Show whether this part is looked for; nothing is announced."""
        with QSignalBlocker(self._detect):
            self._detect.setChecked(detecting)

    @Slot()
    def _on_chosen(self) -> None:
        self.chosen.emit()
