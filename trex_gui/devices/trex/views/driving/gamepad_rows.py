"""One part of a gamepad to choose: from a list, or by moving it."""

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.gamepad.profile import Axis
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.no_wheel_combo_box import NoWheelComboBox


class PartRow(QWidget):
    """A list of parts and a button to find one by moving or pressing it.

    Signals:
        chosen: a person chose another part, or its direction.
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
