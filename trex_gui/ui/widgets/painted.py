"""Base classes for painted widgets, which are never mirrored in right-to-left languages."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QPaintDevice, QPainter
from PySide6.QtWidgets import QGraphicsWidget, QStyle, QWidget

from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import Spoken

_FRAME_MS = 40
_MAX_FRAME = 0.2  # seconds; limits the step after a delay, so that nothing jumps


def never_mirror(target: QWidget | QGraphicsWidget | QPainter) -> None:
    """Disable mirroring in right-to-left languages. Used for sliders and signed numbers."""
    target.setLayoutDirection(Qt.LayoutDirection.LeftToRight)


class Animation:
    """Frame timer for a drawing. The timer stops when the motion ends or the widget is hidden."""

    def __init__(self, widget: QWidget, step: Callable[[float], object]) -> None:
        """`step` receives the seconds since the previous frame."""
        self._widget, self._step = widget, step
        self._timer = new_timer(widget, _FRAME_MS, self._on_frame)
        self._frame_time = 0.0

    @property
    def is_enabled(self) -> bool:
        duration = QStyle.StyleHint.SH_Widget_Animation_Duration
        return self._widget.style().styleHint(duration, None, self._widget) > 0

    def run(self, moves: bool) -> None:
        """Start or stop the timer. Call this again when the widget is shown."""
        if not (moves and self.is_enabled and self._widget.isVisible()):
            self._timer.stop()
        elif not self._timer.isActive():
            self._frame_time = now()
            self._timer.start()

    def _on_frame(self) -> None:
        seconds, self._frame_time = now() - self._frame_time, now()
        if self._widget.isVisible():
            self._step(min(seconds, _MAX_FRAME))
        else:
            self._timer.stop()


class Painter(QPainter):
    """Painter without mirroring. By default, edges are smooth."""

    def __init__(self, device: QPaintDevice, *, smooth: bool = True) -> None:
        super().__init__(device)
        never_mirror(self)
        self.setRenderHint(QPainter.RenderHint.Antialiasing, smooth)


class Painted(QWidget, Spoken):
    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        never_mirror(self)
        theme().changed.connect(self.update)
