"""Sizes and positions of windows, saved and fitted to the screen."""

from PySide6.QtCore import QEvent, QMargins, QObject, QPoint, QRect, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.theme import theme

_FRAME = QMargins(8, 40, 8, 8)
"""Pixels for the title bar and the borders. Their real sizes are unknown until a window is shown.

Windows 11 uses 31 pixels at the top and 8 at the sides. At the top, GNOME uses 37, KDE 30 and
macOS 28.
"""


def fitted(window: QRect, available: QRect) -> QRect:
    """Fit a window and its frame into `available`. `window` and the result exclude the frame."""
    space = available.marginsRemoved(_FRAME)
    size = window.size().boundedTo(space.size())
    limit = space.bottomRight() - QPoint(size.width() - 1, size.height() - 1)
    x = max(space.x(), min(window.x(), limit.x()))
    y = max(space.y(), min(window.y(), limit.y()))
    return QRect(QPoint(x, y), size)


def fit_on_screen(window: QWidget) -> None:
    """Fit a window to the screen whenever it is shown.

    The window is first centred on its parent or the screen. Later it opens where it was closed.
    """
    _Placement(window)


def restore_geometry(window: QWidget, key: str, width: int, height: int) -> None:
    """Restore the saved geometry. If none is saved, use the given size (`resize_with_font`)."""
    resize_with_font(window, width, height)
    window.restoreGeometry(Preferences().data(f"{key}/geometry"))


def resize_with_font(window: QWidget, width: int, height: int) -> None:
    """Resize a window. The size is in pixels at a font size of 100 % and grows with the font."""
    scale = max(theme().font_size, 100) / 100
    window.resize(round(width * scale), round(height * scale))


def save_geometry(window: QWidget, key: str) -> None:
    Preferences().set(f"{key}/geometry", window.saveGeometry())


class _Placement(QObject):
    """Restores the position at which a window was closed.

    A window manager may move a hidden window by the size of its frame. Qt positions a dialog before
    it knows the size of the frame.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._last: QRect | None = None
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        window = self._window
        # Checked before using the window, which receives events even while it is being destroyed.
        if watched is not window or event.spontaneous():
            return False
        if not window.isMaximized() and not window.isFullScreen():
            if event.type() == QEvent.Type.Hide:
                self._last = window.geometry()
            elif event.type() == QEvent.Type.Show:
                geometry = self._last or self._first_geometry()
                screen = QGuiApplication.screenAt(geometry.center()) or window.screen()
                window.setGeometry(fitted(geometry, screen.availableGeometry()))
        return False

    def _first_geometry(self) -> QRect:
        geometry, parent = self._window.geometry(), self._window.parentWidget()
        if not self._window.testAttribute(Qt.WidgetAttribute.WA_Moved):  # not moved or restored
            screen = self._window.screen().availableGeometry()
            geometry.moveCenter((parent.window().frameGeometry() if parent else screen).center())
        return geometry
