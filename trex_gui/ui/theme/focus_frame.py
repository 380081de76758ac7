"""Frame around the widget with the keyboard focus, which Fusion hardly shows."""

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Slot
from PySide6.QtGui import QRegion
from PySide6.QtWidgets import QAbstractScrollArea, QApplication, QFrame, QMenuBar, QTabBar, QWidget
from shiboken6 import Shiboken

_ROOM = 3  # pixels beside the widget
_TYPE = QEvent.Type
_CHANGES = {_TYPE.Hide, _TYPE.Move, _TYPE.ParentChange, _TYPE.Resize, _TYPE.Show}


class FocusFrame(QObject):
    """Frames the widget with the focus, above all else in its window.

    Not a `QFocusFrame`, because PySide would treat the widget as its child, and delete it too.
    """

    def __init__(self, app: QApplication) -> None:
        super().__init__(app)
        self._watched: list[QWidget] = []  # the widget and its ancestors up to the window
        self._frame: QWidget | None = None
        app.focusChanged.connect(self._on_focus_changed)

    @Slot(QWidget, QWidget)
    def _on_focus_changed(self, _before: QWidget | None, focused: QWidget | None) -> None:
        self._end()
        if focused is None or focused.isWindow() or QApplication.mouseButtons():
            return
        if focused.window().windowType() is Qt.WindowType.Popup:  # a menu or a list
            return
        if isinstance(focused, QMenuBar):  # it highlights its current menu itself
            return
        parent: QWidget | None = focused
        while parent is not None:
            parent.installEventFilter(self)
            self._watched.append(parent)
            parent = None if parent.isWindow() else parent.parentWidget()
        self._frame = frame = QFrame(self._watched[-1])
        frame.setObjectName("focusFrame")
        frame.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._place()

    def _end(self) -> None:
        for each in self._watched:
            if Shiboken.isValid(each):
                each.removeEventFilter(self)
        self._watched.clear()
        if self._frame is not None and Shiboken.isValid(self._frame):
            self._frame.hide()
            self._frame.deleteLater()
        self._frame = None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        del watched
        if event.type() in _CHANGES:
            self._place()
        return False

    def _place(self) -> None:
        frame = self._frame
        if frame is None or not all(map(Shiboken.isValid, (frame, *self._watched))):
            return
        window = self._watched[-1]
        around = _place_of(self._watched[0], window).adjusted(-_ROOM, -_ROOM, _ROOM, _ROOM)
        ring = QRegion(around)
        for each in self._watched:
            if isinstance(each.parentWidget(), QAbstractScrollArea):  # it shows only a part
                ring &= QRegion(_place_of(each, window))
        frame.setGeometry(around)
        frame.setMask(ring.translated(-around.topLeft()))
        # An empty mask would mask nothing, and a hidden button may keep the focus.
        frame.setVisible(self._watched[0].isVisible() and not ring.isEmpty())
        frame.raise_()


def _place_of(widget: QWidget, window: QWidget) -> QRect:
    """Return the rectangle of a widget, or of a tab bar's current tab, in its window."""
    place = QRect(QPoint(), widget.size())
    if isinstance(widget, QTabBar):
        place = widget.tabRect(widget.currentIndex()).adjusted(_ROOM, _ROOM, -_ROOM, -_ROOM)
    return place.translated(widget.mapTo(window, QPoint()))
