"""The positions of one pose, to be edited where no robot is needed."""

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QSpinBox, QWidget

from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS, degrees

_ACROSS = 4


class PositionFields(QWidget):
    """A number for each motor, 0-1023; `positions_changed` when a person changes one.

    Signals:
        positions_changed: all positions, a tuple, motor 0 first; and the motor that was changed.
    """

    positions_changed = Signal(object, int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPositions")
        self._limits: tuple[Limits, ...] = ()
        self._whole: tuple[int, ...] = ()
        self._boxes = [self._box(motor) for motor in range(MOTORS)]

        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        for motor, box in enumerate(self._boxes):
            name = QLabel(str(motor), self)
            name.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            name.setBuddy(box)
            row, column = divmod(motor, _ACROSS)
            layout.addWidget(name, row, 2 * column)
            layout.addWidget(box, row, 2 * column + 1)
            layout.setColumnStretch(2 * column + 1, 1)
        self.show_positions(())

    def _box(self, motor: int) -> QSpinBox:
        box = QSpinBox(self)
        box.setObjectName(f"aracnaPosition{motor}")
        box.setAccessibleName(self.tr("Position of motor {0} in this pose").format(motor))
        box.setRange(0, HIGHEST)
        box.setButtonSymbols(QSpinBox.ButtonSymbols.NoButtons)  # keys and wheel do; it is narrow
        box.setKeyboardTracking(False)
        box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        box.valueChanged.connect(self._on_value_changed)
        return box

    def show_positions(self, positions: tuple[int, ...]) -> None:
        """Show the positions of a pose; none greys the fields."""
        self._whole = positions
        self.setEnabled(bool(positions))
        for box, position in zip(self._boxes, positions, strict=False):
            if box.value() != position or not box.text():
                with QSignalBlocker(box):
                    box.setValue(position)
        for box in self._boxes[len(positions) :]:
            box.setEnabled(False)
            box.clear()
        for box in self._boxes[: len(positions)]:
            box.setEnabled(True)
        self._explain()

    def show_limits(self, limits: tuple[Limits, ...]) -> None:
        """Say of each motor how far it may turn."""
        self._limits = limits
        self._explain()

    def _explain(self) -> None:
        for motor, box in enumerate(self._boxes):
            words = [self.tr("Motor {0}: {1:.0f}°").format(motor, degrees(box.value()))]
            if motor < len(self._limits):
                limits = self._limits[motor]
                words.append(self.tr("limits {0} to {1}").format(limits.low, limits.high))
                if not limits.allow(box.value()):
                    words.append(self.tr("sent as {0}").format(limits.crop(box.value())))
            box.setToolTip(", ".join(words))

    @Slot()
    def _on_value_changed(self) -> None:
        box = self.sender()
        motor = next(number for number, one in enumerate(self._boxes) if one is box)
        positions = (*self._whole[:motor], self._boxes[motor].value(), *self._whole[motor + 1 :])
        self._whole = positions
        self._explain()
        self.positions_changed.emit(positions, motor)
