"""Spin boxes of a joint: a position in units or degrees, a speed, a limit."""

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker, QTimer, Slot
from PySide6.QtGui import QFocusEvent, QWheelEvent
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox, QWidget

from trex_gui.devices.aracna.protocol.units import DEGREES_PER_UNIT, HIGHEST
from trex_gui.devices.aracna.views.robot.words import speed_text


class UnitsBox(QSpinBox):
    """A position, or a limit, 0-1023; what is typed counts when it is complete."""

    def __init__(self, name: str, spoken: str, parent: QWidget | None = None) -> None:
        """Be found by `name`, and read out as `spoken`."""
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName(spoken)
        self.setRange(0, HIGHEST)
        self.setKeyboardTracking(False)
        self.setButtonSymbols(QSpinBox.ButtonSymbols.NoButtons)  # the slider is beside it

    def wheelEvent(self, event: QWheelEvent) -> None:
        _only_with_focus(self, event)


class DegreesBox(QDoubleSpinBox):
    """The same position in degrees, 0-300."""

    def __init__(self, name: str, spoken: str, parent: QWidget | None = None) -> None:
        """Be found by `name`, and read out as `spoken`."""
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName(spoken)
        self.setRange(0, HIGHEST * DEGREES_PER_UNIT)
        self.setDecimals(1)
        self.setSuffix("°")
        self.setButtonSymbols(QSpinBox.ButtonSymbols.NoButtons)
        self.setKeyboardTracking(False)

    def wheelEvent(self, event: QWheelEvent) -> None:
        _only_with_focus(self, event)


class SpeedBox(QSpinBox):
    """A speed setting, 0-1023, and what it means; 0 is no speed limit, and says so."""

    def __init__(self, name: str, spoken: str, parent: QWidget | None = None) -> None:
        """Be found by `name`, and read out as `spoken`."""
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName(spoken)
        self.setRange(0, HIGHEST)
        self.setSingleStep(10)
        self.setKeyboardTracking(False)
        self.setToolTip(
            self.tr(
                "Speed setting 1-1023, 0.669 °/s each; 0 is as fast as it can, not “stopped”. "
                "Above about 870 (AX-18A) or 530 (AX-12A) a servo gets no faster."
            )
        )
        self.valueChanged.connect(self.renew_meaning)
        self.renew_meaning()

    def wheelEvent(self, event: QWheelEvent) -> None:
        _only_with_focus(self, event)

    @Slot()
    def renew_meaning(self) -> None:
        """Say what the value means; by itself it does so when a change is told."""
        value = self.value()
        self.setSuffix(f" = {speed_text(value)}" if value else self.tr(" = fastest"))


class SpeedOfAllBox(SpeedBox):
    """The speed that all motors share; where they differ it says so until one is chosen."""

    _NONE = -1

    def __init__(self, name: str, spoken: str, parent: QWidget | None = None) -> None:
        """Be found by `name`, and read out as `spoken`."""
        super().__init__(name, spoken, parent)
        self.setMinimumWidth(self.sizeHint().width())  # it does not jump when they differ

    @property
    def differ(self) -> bool:
        """Whether the motors have not all the same speed."""
        return self.value() == self._NONE

    def show_speeds(self, speeds: Sequence[int]) -> None:
        """Show the speeds of all motors; nothing is told of it, and what is typed stays."""
        shared = set(speeds)
        value = shared.pop() if len(shared) == 1 else self._NONE
        lowest = min(value, 0)  # that they differ is nothing to choose
        if (value, lowest) == (self.value(), self.minimum()):
            return
        with QSignalBlocker(self):
            self.setMinimum(lowest)
            self.setSpecialValueText(self.tr("differ") if value == self._NONE else "")
            self.setValue(value)
        self.renew_meaning()

    def stepBy(self, steps: int) -> None:
        """Step from nothing where they differ."""
        if not self.differ:
            super().stepBy(steps)
        elif steps > 0:
            self.setValue(steps * self.singleStep())

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Let a speed be typed in place of the words, also by who has clicked into them."""
        super().focusInEvent(event)
        if self.differ:
            QTimer.singleShot(0, self, self.selectAll)


def _only_with_focus(box: QSpinBox | QDoubleSpinBox, event: QWheelEvent) -> None:
    """Let the wheel change a box that has the focus; else it scrolls the page."""
    if not box.hasFocus():
        event.ignore()
    elif isinstance(box, QSpinBox):
        QSpinBox.wheelEvent(box, event)
    else:
        QDoubleSpinBox.wheelEvent(box, event)
