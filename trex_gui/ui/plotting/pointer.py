"""The mouse over a plot: what a person means by it, in pixels."""

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QRubberBand, QWidget

_DRAG = 5
"""Pixels that a pressed mouse moves before it drags rather than clicks."""

_STEP = 0.8
"""How much less is shown after one notch of the wheel."""


class Pointer(QObject):
    """Takes every event of the mouse from a plot's viewport.

    Signals:
        hovered: over which pixel from the left.
        left: the mouse is elsewhere.
        clicked: pressed and let go at this pixel.
        chosen: a span was drawn, from one pixel to another.
        zoomed: how much more to show, around which pixel.
        panned: how many pixels the content was moved to the right.
    """

    hovered = Signal(float)
    left = Signal()
    clicked = Signal(float)
    chosen = Signal(float, float)
    zoomed = Signal(float, float)
    panned = Signal(float)

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport)
        self._viewport = viewport
        self._band = QRubberBand(QRubberBand.Shape.Rectangle, viewport)
        self._pressed: QPoint | None = None
        self._button = Qt.MouseButton.NoButton
        self._moved_to: QPoint | None = None
        self._draws = False  # a span
        self._moves = False  # the picture
        viewport.setMouseTracking(True)
        viewport.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: ARG002 - Qt's face
        if isinstance(event, QWheelEvent):
            self._on_wheel(event)
            return True
        if event.type() == QEvent.Type.Leave:
            self.left.emit()
        if not isinstance(event, QMouseEvent):
            return False
        match event.type():
            case QEvent.Type.MouseButtonPress if self._pressed is None:
                self._pressed = self._moved_to = event.position().toPoint()
                self._button = event.button()
                # The plot itself takes the focus, so that its keys work.
                return False
            case QEvent.Type.MouseMove:
                self._on_moved(event)
            case QEvent.Type.MouseButtonRelease if event.button() == self._button:
                self._on_released(event)
        return True

    def _on_wheel(self, event: QWheelEvent) -> None:
        turned = event.angleDelta()
        if abs(turned.x()) > abs(turned.y()):
            self.panned.emit(turned.x() / 2)
        elif turned.y():
            self.zoomed.emit(_STEP ** (turned.y() / 120), event.position().x())

    def _pans(self, event: QMouseEvent) -> bool:
        with_shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        return self._button != Qt.MouseButton.LeftButton or with_shift

    def _on_moved(self, event: QMouseEvent) -> None:
        at = event.position().toPoint()
        self.hovered.emit(event.position().x())
        if self._pressed is None or self._moved_to is None:
            return
        if not (self._draws or self._moves):
            if abs(at.x() - self._pressed.x()) < _DRAG:
                return
            self._moves = self._pans(event)
            self._draws = not self._moves
        if self._moves:
            self.panned.emit(float(at.x() - self._moved_to.x()))
        else:
            left, right = sorted((at.x(), self._pressed.x()))
            self._band.setGeometry(QRect(left, 0, right - left, self._viewport.height()))
            self._band.show()
        self._moved_to = at

    def _on_released(self, event: QMouseEvent) -> None:
        pressed, self._pressed = self._pressed, None
        drew, moved = self._draws, self._moves
        self._draws = self._moves = False
        self._band.hide()
        if pressed is None:
            return
        x = event.position().x()
        if drew:
            self.chosen.emit(float(pressed.x()), x)
        elif not moved and self._button == Qt.MouseButton.LeftButton:
            self.clicked.emit(x)
