"""Painted widgets, sliders and numbers keep left and right in right-to-left languages."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QPaintDevice, QPainter
from PySide6.QtWidgets import QGraphicsWidget, QWidget

from trex_gui.ui.widgets.accessible import Spoken

_DIRECTION = Qt.LayoutDirection.LeftToRight


def never_mirror(widget: QWidget | QGraphicsWidget) -> None:
    """Keep the ends of a slider, and the sign before a number."""
    widget.setLayoutDirection(_DIRECTION)


class Painter(QPainter):
    """Painter whose text runs from left to right.

    The direction of `QPainter` is that of the application, not of the widget.
    """

    def __init__(self, device: QPaintDevice) -> None:
        super().__init__(device)
        self.setLayoutDirection(_DIRECTION)


class Painted(QWidget, Spoken):
    """A widget that paints itself with a `Painter`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        never_mirror(self)
