"""Frame around the focused widget, since Fusion's own focus marks are hard to see."""

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Slot
from PySide6.QtGui import QRegion
from PySide6.QtWidgets import QAbstractScrollArea, QApplication, QFrame, QMenuBar, QTabBar, QWidget
from shiboken6 import Shiboken

_MARGIN = 3  # pixels around the widget
_TYPE = QEvent.Type
_CHANGES = {_TYPE.Hide, _TYPE.Move, _TYPE.ParentChange, _TYPE.Resize, _TYPE.Show}


# Does not use `QFocusFrame`: PySide would treat the framed widget as its child and delete it.
class FocusFrame(QObject):
    def __init__(self, app: QApplication) -> None:
        super().__init__(app)
        self._watched: list[QWidget] = []  # focused widget, then its ancestors up to the window
        self._frame: QWidget | None = None
        app.focusChanged.connect(self._on_focus_changed)

    @Slot(QWidget, QWidget)
    def _on_focus_changed(self, _before: QWidget | None, focused: QWidget | None) -> None:
        self._remove()
        if focused is None or focused.isWindow() or QApplication.mouseButtons():
            return
        if focused.window().windowType() is Qt.WindowType.Popup:  # a menu or a list
            return
        if isinstance(focused, QMenuBar):  # highlights its current menu itself
            return
        parent: QWidget | None = focused
        while parent is not None:
            parent.installEventFilter(self)
            self._watched.append(parent)
            parent = None if parent.isWindow() else parent.parentWidget()
        self._frame = frame = QFrame(self._watched[-1])
        frame.setObjectName("focusFrame")
        frame.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._move()

    def _remove(self) -> None:
        for widget in self._watched:
            if Shiboken.isValid(widget):
                widget.removeEventFilter(self)
        self._watched.clear()
        if self._frame is not None and Shiboken.isValid(self._frame):
            self._frame.hide()
            self._frame.deleteLater()
        self._frame = None

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() in _CHANGES:
            self._move()
        return False

    def _move(self) -> None:
        frame = self._frame
        if frame is None or not all(map(Shiboken.isValid, (frame, *self._watched))):
            return
        window = self._watched[-1]
        area = _area_of(self._watched[0], window).adjusted(-_MARGIN, -_MARGIN, _MARGIN, _MARGIN)
        visible = QRegion(area)
        for widget in self._watched:
            if isinstance(widget.parentWidget(), QAbstractScrollArea):  # clips its content
                visible &= QRegion(_area_of(widget, window))
        frame.setGeometry(area)
        frame.setMask(visible.translated(-area.topLeft()))
        # Qt ignores an empty mask, and even a hidden button may have the focus.
        frame.setVisible(self._watched[0].isVisible() and not visible.isEmpty())
        frame.raise_()


def _area_of(widget: QWidget, window: QWidget) -> QRect:
    """Return the area of a widget in the window. For a tab bar, return the current tab's area."""
    area = QRect(QPoint(), widget.size())
    if isinstance(widget, QTabBar):
        area = widget.tabRect(widget.currentIndex())
        area = area.adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)
    return area.translated(widget.mapTo(window, QPoint()))
