"""Scroll area for pages that may not fit on the screen."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

_LINES = 4  # minimum height in lines of text
_CHARACTERS = 24  # minimum width if the area scrolls sideways, in average characters
_MAX_MINIMUM_WIDTH = 664
"""Maximum of the minimum width in pixels. The places and the demo panel need the rest of a screen
that is 1024 pixels wide."""


class ScrollBox(QScrollArea):
    """Scroll area that scrolls only if its content cannot shrink further.

    With `widgetResizable`, Qt would scroll earlier, because it would use the preferred height of
    wrapped text.
    """

    def __init__(
        self,
        content: QWidget | Callable[[QWidget], QWidget],
        parent: QWidget | None = None,
        *,
        sideways: bool = False,
    ) -> None:
        """Create the area. `sideways`: the area may be narrower than its content.

        `content`: a widget, or a function that creates the widget in a parent.
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
        hint, layout = self.content.sizeHint(), self.content.layout()
        if layout is not None and layout.hasHeightForWidth() and self.isVisible():
            space = self.maximumViewportSize()
            frame = self.height() - space.height()
            hint.setHeight(layout.totalHeightForWidth(space.width()) + frame)
        return hint

    def minimumSizeHint(self) -> QSize:
        content = self.content.minimumSizeHint()
        lines = _LINES * self.fontMetrics().lineSpacing()
        bar = self.verticalScrollBar().sizeHint().width()
        widest = _MAX_MINIMUM_WIDTH
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
        size = self.maximumViewportSize()
        if self._minimum_height(size.width()) > size.height():
            size.setWidth(size.width() - self.verticalScrollBar().sizeHint().width())
        size.setWidth(max(size.width(), self.content.minimumSizeHint().width()))
        self.content.resize(size.width(), max(size.height(), self._minimum_height(size.width())))
        self._fitting = False

    def _minimum_height(self, width: int) -> int:
        layout = self.content.layout()
        height = self.content.minimumSizeHint().height()
        if layout is not None and layout.hasHeightForWidth():
            height = max(height, layout.totalMinimumHeightForWidth(width))
        return height
