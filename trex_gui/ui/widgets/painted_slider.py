"""A slider with the style's handle on a groove of its own."""

from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from trex_gui.ui.theme.theme import theme


class PaintedSlider(QSlider):
    """Horizontal; whoever derives from it paints the groove, and what stands below the handle."""

    def __init__(self, lowest: int, highest: int, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self.setRange(lowest, highest)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        theme().changed.connect(self.update)

    def room_below(self) -> int:
        """Return the pixels of height below groove and handle."""
        return 0

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        """Paint what lies under the handle; `x_of` says where a value is."""
        raise NotImplementedError

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        """Paint what stands below the handle; nothing, where nothing does."""

    def initStyleOption(self, option: QStyleOptionSlider) -> None:
        """Keep groove and handle, painted or clicked on, above what stands below."""
        super().initStyleOption(option)
        option.rect = self.rect().adjusted(0, 0, 0, -self.room_below())

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        slider, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        handle = self.style().subControlRect(slider, option, part, self)
        option.subControls = part
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self.paint_groove(painter, handle)
            self.style().drawComplexControl(slider, option, painter, self)
            self.paint_below(painter, handle)

    def x_of(self, value: int, handle: QRect) -> int:
        """Return where the middle of a handle of this size is at a value."""
        room = self.width() - handle.width()
        return handle.width() // 2 + QStyle.sliderPositionFromValue(
            self.minimum(), self.maximum(), value, room
        )
