"""Painted widgets, sliders and numbers keep left and right in right-to-left languages."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QPaintDevice, QPainter
from PySide6.QtWidgets import QGraphicsWidget, QStyle, QWidget

from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import Spoken


def never_mirror(target: QWidget | QGraphicsWidget | QPainter) -> None:
    """Keep the ends of a slider, and the sign before a number."""
    target.setLayoutDirection(Qt.LayoutDirection.LeftToRight)


def wants_motion(widget: QWidget) -> bool:
    """Return whether the system lets drawings move."""
    duration = QStyle.StyleHint.SH_Widget_Animation_Duration
    return widget.style().styleHint(duration, None, widget) > 0


class Painter(QPainter):
    """Painter that does not follow the direction of the application. Edges are smooth."""

    def __init__(self, device: QPaintDevice, *, smooth: bool = True) -> None:
        super().__init__(device)
        never_mirror(self)
        self.setRenderHint(QPainter.RenderHint.Antialiasing, smooth)


class Painted(QWidget, Spoken):
    """A widget that paints itself with a `Painter`, in the colours of the theme."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        never_mirror(self)
        theme().changed.connect(self.update)
