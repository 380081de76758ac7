"""A name, a slider and a number that always show the same strength of 127."""

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QSlider, QSpinBox, QWidget

from trex_gui.protocol.calibration import FULL_SCALE


class Level(QObject):
    """Lies in three cells of a row of a grid. The mouse wheel leaves it alone.

    Signals:
        changed: a value that a person chose.
    """

    changed = Signal(int)

    def __init__(self, title: str, name: str, lowest: int, parent: QWidget) -> None:
        super().__init__(parent)
        self._label = QLabel(title, parent)
        self._slider = QSlider(Qt.Orientation.Horizontal, parent)
        self._slider.setObjectName(f"{name}Slider")
        self._slider.setRange(lowest, FULL_SCALE)
        self._slider.setPageStep(16)
        self._slider.setMinimumWidth(90)
        self._entry = QSpinBox(parent)
        self._entry.setObjectName(f"{name}Entry")
        self._entry.setRange(lowest, FULL_SCALE)
        self._entry.setKeyboardTracking(False)
        self._label.setBuddy(self._entry)
        plain = title.replace("&", "")
        self._slider.setAccessibleName(plain)
        self._entry.setAccessibleName(self.tr("{0}, as a number").format(plain))
        for widget in (self._slider, self._entry):
            widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            widget.installEventFilter(self)
        self._entry.setSuffix(_share(FULL_SCALE))
        self._entry.setMinimumWidth(self._entry.sizeHint().width())

        self._slider.valueChanged.connect(self._on_moved)
        self._entry.valueChanged.connect(self._on_typed)

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
        with QSignalBlocker(self._slider), QSignalBlocker(self._entry):
            self._slider.setValue(value)
            self._entry.setSuffix(_share(value))
            self._entry.setValue(value)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    @Slot(int)
    def _on_moved(self, value: int) -> None:
        self.set_value(value)
        self.changed.emit(value)

    @Slot(int)
    def _on_typed(self, value: int) -> None:
        self.set_value(value)
        self.changed.emit(value)


def _share(value: int) -> str:
    return f" ({100 * value / FULL_SCALE:.0f} %)"
