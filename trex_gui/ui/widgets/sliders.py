"""Sliders with a painted groove."""

from PySide6.QtCore import QRect, QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QAccessible, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QLabel, QSlider, QStyle, QStyleOptionSlider, QWidget

from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import Spoken, SpokenRange
from trex_gui.ui.widgets.behaviour import PressMonitor, focused_wheel
from trex_gui.ui.widgets.painted import Painter, never_mirror


class PaintedSlider(QSlider, Spoken):
    spoken_role = QAccessible.Role.Slider
    positions_per_unit = 1.0  # slider positions per displayed unit
    space_below = 0  # pixels below the groove and the handle

    wheelEvent = focused_wheel(QSlider.wheelEvent)

    def __init__(self, lowest: int, highest: int, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        never_mirror(self)
        self.setRange(lowest, highest)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        theme().changed.connect(self.update)

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        raise NotImplementedError

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        """Paint `space_below`. Does nothing by default."""

    def spoken_range(self) -> SpokenRange:
        positions = self.minimum(), self.value(), self.maximum()
        return SpokenRange(*(position / self.positions_per_unit for position in positions))

    def set_spoken_value(self, value: float) -> None:
        self.setValue(round(value * self.positions_per_unit))

    def initStyleOption(self, option: QStyleOptionSlider) -> None:
        """Exclude `space_below` from painting and clicks."""
        super().initStyleOption(option)
        option.rect = self.rect().adjusted(0, 0, 0, -self.space_below)

    def paintEvent(self, _event: QPaintEvent) -> None:
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        slider, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        handle = self.style().subControlRect(slider, option, part, self)
        option.subControls = part
        with Painter(self) as painter:
            self.paint_groove(painter, handle)
            self.style().drawComplexControl(slider, option, painter, self)
            self.paint_below(painter, handle)
            if self.hasFocus():  # even after a click, because arrow keys move the handle
                painter.setPen(QPen(theme().color("highlight"), 2))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawRoundedRect(handle.adjusted(1, 1, -1, -1), 2, 2)

    def x_of(self, value: int, handle: QRect) -> int:
        """Return the x coordinate of the handle's centre at a value."""
        span = self.width() - handle.width()
        return handle.width() // 2 + QStyle.sliderPositionFromValue(
            self.minimum(), self.maximum(), value, span
        )


class PressSlider(PaintedSlider):
    """Slider that is held with the left mouse button. Losing the input releases it."""

    grabbed = Signal()  # start of a hold
    released = Signal()  # end of a hold

    def __init__(self, lowest: int, highest: int, parent: QWidget | None = None) -> None:
        super().__init__(lowest, highest, parent)
        self.held = False
        self._monitor = PressMonitor(self)
        self._monitor.lost.connect(self.release)

    @Slot()
    def release(self) -> None:
        """End the hold until the user presses again."""
        if self.held:
            self.held = False
            self._monitor.end()
            self.setSliderDown(False)
            self.setRepeatAction(QSlider.SliderAction.SliderNoAction)
            self.released.emit()

    def grab_handle(self) -> None:
        if not self.held:
            self.held = True
            self._monitor.start()
            self.grabbed.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Ignore all buttons except the left. On a middle click, Qt would move the handle."""
        event.ignore()
        if event.button() is Qt.MouseButton.LeftButton:
            self.grab_handle()
            super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.isSliderDown() and not event.buttons() & Qt.MouseButton.LeftButton:
            self.release()  # Qt did not report the release of the button
        if self.held:  # a released handle must not follow the mouse
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.ignore()
        if event.button() is Qt.MouseButton.LeftButton:
            super().mouseReleaseEvent(event)
            self.release()


class StickSlider(PaintedSlider):
    """Slider filled from `neutral` to its value. `valueChanged` only reports the user's changes."""

    def __init__(
        self, lowest: int, highest: int, neutral: int, color: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(lowest, highest, parent)
        self._neutral = neutral
        self._color = color
        self.value_label: QLabel | None = None  # shows the value with its unit
        self.setValue(neutral)

    def spoken_state(self) -> str:
        return "" if self.value_label is None else self.value_label.text()

    def follow(self, value: int) -> None:
        """Show a value that the user did not set. Does nothing during a drag."""
        if not self.isSliderDown() and value != self.value():
            with QSignalBlocker(self):
                self.setValue(value)

    def sizeHint(self) -> QSize:
        return QSize(120, super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(40, super().minimumSizeHint().height())

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self.setSliderDown(False)
            self.setValue(self._neutral)
            event.accept()

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        color = theme().color
        middle = handle.center().y()
        left, right = self.x_of(self.minimum(), handle), self.x_of(self.maximum(), handle)
        painter.setPen(QPen(color("track_edge")))
        painter.setBrush(color("track" if self.isEnabled() else "track_off"))
        painter.drawRoundedRect(QRect(left, middle - 2, right - left, 5), 2, 2)
        neutral_x, handle_x = self.x_of(self._neutral, handle), handle.center().x()
        if self.isEnabled():
            start, end = max(min(neutral_x, handle_x), left + 2), max(neutral_x, handle_x)
            painter.fillRect(start, middle - 1, max(end - start, 0), 4, color(self._color))
        if self.minimum() < self._neutral < self.maximum():
            painter.fillRect(neutral_x, middle - 6, 1, 13, color("mark"))
