"""Behaviour that widgets share: focus, headers, held controls, typed values."""

from collections.abc import Callable, Iterator
from functools import wraps
from math import inf
from typing import TypeVar

from PySide6.QtCore import QEvent, QObject, Qt, Signal, Slot
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QShowEvent, QTransform, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QDialog,
    QHeaderView,
    QPushButton,
    QWidget,
)

from trex_gui.core.translation import tr
from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import set_look, theme
from trex_gui.ui.widgets.placement import fit_on_screen

ENTER = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
_PRESSES = {QEvent.Type.KeyPress, QEvent.Type.KeyRelease}
_POLL_MS = 50
_LOSSES = {
    QEvent.Type.FocusOut,
    QEvent.Type.Hide,
    QEvent.Type.TouchCancel,
    QEvent.Type.UngrabMouse,
    QEvent.Type.WindowDeactivate,
}


class EnterWatch(QObject):
    """Lets Enter press the button with the focus, as Space does, in every window.

    Qt lets Enter press the default button of a dialog, and no button in other windows.
    """

    def __init__(self, app: QApplication, parent: QObject) -> None:
        super().__init__(parent)
        app.focusChanged.connect(self._on_focus_changed)

    @Slot(QWidget, QWidget)
    def _on_focus_changed(self, _before: QWidget | None, focused: QWidget | None) -> None:
        if isinstance(focused, QAbstractButton):
            focused.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.type() not in _PRESSES:
            return False
        keypad = Qt.KeyboardModifier.KeypadModifier
        if event.key() not in ENTER or event.modifiers() & ~keypad:
            return False
        space, modifiers = Qt.Key.Key_Space, Qt.KeyboardModifier.NoModifier
        as_space = QKeyEvent(event.type(), space, modifiers, " ", event.isAutoRepeat())
        QApplication.sendEvent(watched, as_space)
        return True


class ReusedDialog(QDialog):
    """A dialog that is kept while it is hidden, and opens the same way each time.

    Opens with the focus on its default button. Qt would leave the focus where it was.
    """

    stays_on_stop = False  # True: an Esc that stops motors does not close it

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        fit_on_screen(self)

    def setVisible(self, visible: bool) -> None:
        if visible and not self.isVisible():
            if (focused := self.focusWidget()) is not None:
                focused.clearFocus()
            for button in self.findChildren(QPushButton):
                if button.isDefault():
                    button.setFocus()
        super().setVisible(visible)

    def show_in_front(self) -> None:
        self.show()
        self.activateWindow()


def paint_placeholder(view: QAbstractItemView, text: str, *, short: str = "") -> None:
    """Paint a text into an empty view, or `short` where the text does not fit."""
    box = view.viewport().rect().adjusted(8, 4, -8, -4)
    how = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    with QPainter(view.viewport()) as painter:
        painter.setPen(theme().color("muted"))
        if short and not box.contains(painter.boundingRect(box, how, text)):
            text = short if text else ""
        painter.drawText(box, how, text)


def strokes(painter: QPainter) -> Iterator[None]:
    """Shift the painter for each thin stroke of a line one logical pixel wide.

    A pen of two pixels would take a hundred times as long for a noisy curve.
    """
    base = painter.worldTransform()
    ratio = painter.deviceTransform().m22() / base.m22()
    for pixel in range(max(1, round(ratio))):
        for x, y in {(pixel, 0), (0, pixel)}:
            painter.setWorldTransform(base * QTransform.fromTranslate(x / ratio, y / ratio))
            yield
    painter.setWorldTransform(base)


def name_headers(view: QAbstractItemView) -> None:
    for header in view.findChildren(QHeaderView, options=Qt.FindChildOption.FindDirectChildrenOnly):
        across = header.orientation() is Qt.Orientation.Horizontal
        header.setAccessibleName(tr("Columns") if across else tr("Rows"))


def reserve_space(widget: QWidget) -> None:
    """Reserve a widget's space in the layout while it is hidden."""
    policy = widget.sizePolicy()
    policy.setRetainSizeWhenHidden(True)
    widget.setSizePolicy(policy)


class PressMonitor(QObject):
    """Detects when a held control loses the input that would end the hold.

    An opening menu or dialog swallows the release of a mouse button or key without any event, so
    the control is also polled while it is held.
    """

    # The widget lost focus or mouse, was hidden or disabled, or is covered by a menu, a dialog or
    # another window.
    lost = Signal()

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._was_active = False
        self._timer = new_timer(self, _POLL_MS, self._on_poll)
        widget.installEventFilter(self)

    def start(self) -> None:
        """Start watching, unless already started."""
        if not self._timer.isActive():
            self._was_active = self._widget.isActiveWindow()
            self._timer.start()

    def end(self) -> None:
        self._timer.stop()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_disabled = event.type() == QEvent.Type.EnabledChange and not self._widget.isEnabled()
        if watched is self._widget and (event.type() in _LOSSES or is_disabled):
            self._lose()
        return False

    @Slot()
    def _on_poll(self) -> None:
        is_covered = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        is_left = self._was_active and not self._widget.isActiveWindow()
        if is_covered or is_left or not self._widget.isVisible():
            self._lose()

    def _lose(self) -> None:
        if self._timer.isActive():
            self.end()
            self.lost.emit()


class ConfirmButton(QPushButton):
    """Ignores clicks until it has been visible, unchanged, for a double-click interval.

    The double click that makes it appear under the pointer cannot press it. Early clicks do not
    prolong the wait.
    """

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self._appeared = -inf  # seconds; when it was shown, or its function changed

    @property
    def takes_clicks(self) -> bool:
        return now() - self._appeared > QApplication.doubleClickInterval() / 1000

    def hold_off(self) -> None:
        """Restart the wait, because the button's function changes."""
        self._appeared = now()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if not event.spontaneous():
            self.hold_off()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self.takes_clicks:
            super().mousePressEvent(event)


class RedButton(QPushButton):
    """Stop button: acts on press, not on release. It is never the default of a dialog."""

    def __init__(
        self, name: str, text: str, stop: Callable[[], object], parent: QWidget | None
    ) -> None:
        super().__init__(text, parent)
        self.setObjectName(name)
        self.setAccessibleName(text)
        self.setAutoDefault(False)
        set_look(self, "stop")
        set_icon(self, "stop", "stop_text")
        self.pressed.connect(stop)


class HoldButton(QPushButton):
    """Button held with the mouse, a finger, the space bar or Enter.

    Any loss of input (`PressMonitor`) releases it, and so does a mouse that leaves it. Then the
    user has to press again: returning with the mouse button down does not count.
    """

    hold_started = Signal()
    hold_ended = Signal()

    is_held = False

    def __init__(self, text: str, parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setAutoDefault(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._monitor = PressMonitor(self)
        self._monitor.lost.connect(self._end)

    def _start(self) -> None:
        if not self.is_held and self.isEnabled():
            self.is_held = True
            self._monitor.start()
            self.hold_started.emit()

    @Slot()
    def _end(self) -> None:
        self._monitor.end()
        if self.is_held:
            self.is_held = False
            self.setDown(False)
            self.hold_ended.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        if event.button() == Qt.MouseButton.LeftButton:
            self._start()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.is_held:  # else Qt would press the button again when the mouse returns
            if not self.rect().contains(event.position().toPoint()):
                self._end()
            event.accept()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._end()
        super().mouseReleaseEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        super().keyPressEvent(event)
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._start()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._end()
        super().keyReleaseEvent(event)


WidgetT = TypeVar("WidgetT", bound=QWidget)


def focused_wheel(turn: Callable[[WidgetT, QWheelEvent], None]) -> Callable[..., None]:
    """Return a `wheelEvent` that changes only a focused widget. Otherwise the page scrolls."""

    def wheel_event(widget: WidgetT, event: QWheelEvent) -> None:
        if widget.hasFocus():
            turn(widget, event)
        else:
            event.ignore()

    return wheel_event


def only_when_visible(slot: Callable[[WidgetT], None]) -> Callable[[WidgetT], None]:
    """Run a slot only while its widget is visible.

    The widget calls the slot again from its `showEvent`.
    """

    @wraps(slot)
    def guarded(widget: WidgetT) -> None:
        if widget.isVisible():
            slot(widget)

    return guarded


def set_typed() -> None:
    """Commit the text of the focused spin box or cell.

    The editor commits by itself when it loses the focus, but a shortcut or a menu does not take
    the focus, nor does a button on a Mac.
    """
    box = QApplication.focusWidget()
    viewport = box.parentWidget() if box is not None else None
    view = viewport.parentWidget() if viewport is not None else None
    if isinstance(view, QAbstractItemView) and view.viewport() is viewport:
        view.setFocus()  # the editor of a cell commits when it loses the focus
    elif isinstance(box, QAbstractSpinBox):
        box.interpretText()
