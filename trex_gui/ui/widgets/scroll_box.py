"""Page that scrolls only where the screen is too small for it."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

_LINES = 4
_CHARACTERS = 24  # of average width: minimum width of a box that scrolls sideways
_WIDEST = 664  # pixels, largest minimum width: space beside places and demo panel at 1024


class ScrollBox(QScrollArea):
    """Gives a widget the visible height, and scrolls it if it needs more for its width.

    With `widgetResizable`, Qt would also scroll content that can still shrink, because it gives
    wrapped text its preferred height.
    """

    def __init__(
        self,
        content: QWidget | Callable[[QWidget], QWidget],
        parent: QWidget | None = None,
        *,
        sideways: bool = False,
    ) -> None:
        """`content`: a widget, or a function that creates it in a parent, to style it only once.

        `sideways`: the box may be narrower than the content, and then also scrolls sideways.
        Otherwise this happens only where large fonts make a page wider than a small screen.
        """
        super().__init__(parent)
        if not isinstance(content, QWidget):
            content = content(self.viewport())
        self.content = content
        self._sideways = sideways
        self._fitting = False
        self.setObjectName(f"{content.objectName()}Area")
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidget(content)
        content.setAutoFillBackground(False)
        self.viewport().setAutoFillBackground(False)

    def sizeHint(self) -> QSize:
        """Return the content's size hint, with its preferred height at the available width."""
        hint, layout = self.content.sizeHint(), self.content.layout()
        if layout is not None and layout.hasHeightForWidth() and self.isVisible():
            room = self.maximumViewportSize()
            around = self.height() - room.height()
            hint.setHeight(layout.totalHeightForWidth(room.width()) + around)
        return hint

    def minimumSizeHint(self) -> QSize:
        content = self.content.minimumSizeHint()
        lines = _LINES * self.fontMetrics().lineSpacing()
        bar = self.verticalScrollBar().sizeHint().width()
        widest = _WIDEST
        if self._sideways:
            widest = _CHARACTERS * self.fontMetrics().averageCharWidth()
        return QSize(min(content.width(), widest) + bar, min(content.height(), lines))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest and watched is self.content:
            self._fit()
            self.updateGeometry()
        return super().eventFilter(watched, event)

    def _fit(self) -> None:
        if self._fitting:  # a scroll bar is being shown or hidden
            return
        self._fitting = True
        room = self.maximumViewportSize()
        if self._needed(room.width()) > room.height():
            room.setWidth(room.width() - self.verticalScrollBar().sizeHint().width())
        room.setWidth(max(room.width(), self.content.minimumSizeHint().width()))
        self.content.resize(room.width(), max(room.height(), self._needed(room.width())))
        self._fitting = False

    def _needed(self, width: int) -> int:
        layout = self.content.layout()
        needed = self.content.minimumSizeHint().height()
        if layout is not None and layout.hasHeightForWidth():
            needed = max(needed, layout.totalMinimumHeightForWidth(width))
        return needed
