"""A name, a slider and a number that always show the same strength of 127."""

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QSlider, QWidget

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.pages.motors.speed_entry import SpeedEntry
from trex_gui.ui.widgets import builders as ui


class _StrengthEntry(SpeedEntry):
    """A box that shows beside the number what share of full it is."""

    def put(self, speed: int) -> None:
        with QSignalBlocker(self):  # writing a suffix writes the text anew
            self.setSuffix(_share(speed))
        super().put(speed)


class Level(QObject):
    """Lies in three cells of a row of a grid. The mouse wheel leaves it alone.

    A number that is typed counts with Enter only, as a speed does: a ceiling that was half typed
    would let a motor run as fast as nobody meant.

    Signals:
        changed: a value that a person chose.
    """

    changed = Signal(int)

    def __init__(self, title: str, name: str, lowest: int, parent: QWidget) -> None:
        super().__init__(parent)
        self._label = QLabel(title, parent)
        self._slider = ui.named(QSlider(Qt.Orientation.Horizontal, parent), f"{name}Slider")
        self._slider.setRange(lowest, FULL_SCALE)
        self._slider.setPageStep(16)
        self._slider.setMinimumWidth(90)
        self._entry = ui.named(_StrengthEntry(parent), f"{name}Entry")
        self._entry.setRange(lowest, FULL_SCALE)
        self._label.setBuddy(self._entry)
        plain = title.replace("&", "")
        self._slider.setAccessibleName(plain)
        self._entry.setAccessibleName(self.tr("{0}, as a number").format(plain))
        for widget in (self._slider, self._entry):
            widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            widget.installEventFilter(self)
        self._entry.put(FULL_SCALE)
        self._entry.setMinimumWidth(self._entry.sizeHint().width())

        self._slider.valueChanged.connect(self._on_chosen)
        self._entry.chosen.connect(self._on_chosen)

    def add_to(self, grid: QGridLayout, row: int) -> None:
        """Take three cells of a row."""
        for column, widget in enumerate((self._label, self._slider, self._entry)):
            grid.addWidget(widget, row, column)

    def explain(self, text: str) -> None:
        """Say what it is for."""
        for widget in (self._label, self._slider, self._entry):
            widget.setToolTip(text)

    def name_lowest(self, text: str) -> None:
        """Show this in place of the lowest number."""
        self._entry.setSpecialValueText(text)

    def set_value(self, value: int) -> None:
        """Show a value that no person chose."""
        with QSignalBlocker(self._slider):
            self._slider.setValue(value)
        self._entry.show_wish(value)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    @Slot(int)
    def _on_chosen(self, value: int) -> None:
        self.set_value(value)
        self.changed.emit(value)


def _share(value: int) -> str:
    return f" ({100 * value / FULL_SCALE:.0f} %)"
