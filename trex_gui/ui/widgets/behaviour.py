"""Shared behaviour of widgets: focus, headers, held controls, typed values."""

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
_KEY_EVENTS = {QEvent.Type.KeyPress, QEvent.Type.KeyRelease}
_POLL_MS = 50
_INPUT_LOSS_EVENTS = {
    QEvent.Type.FocusOut,
    QEvent.Type.Hide,
    QEvent.Type.TouchCancel,
    QEvent.Type.UngrabMouse,
    QEvent.Type.WindowDeactivate,
}


class EnterWatch(QObject):
    """Makes Enter press the focused button, as Space does.

    In Qt, Enter presses the default button of a dialog, and no button in other windows.
    """

    def __init__(self, app: QApplication, parent: QObject) -> None:
        super().__init__(parent)
        app.focusChanged.connect(self._on_focus_changed)

    @Slot(QWidget, QWidget)
    def _on_focus_changed(self, _before: QWidget | None, focused: QWidget | None) -> None:
        if isinstance(focused, QAbstractButton):
            focused.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.type() not in _KEY_EVENTS:
            return False
        keypad = Qt.KeyboardModifier.KeypadModifier
        if event.key() not in ENTER or event.modifiers() & ~keypad:
            return False
        space, modifiers = Qt.Key.Key_Space, Qt.KeyboardModifier.NoModifier
        as_space = QKeyEvent(event.type(), space, modifiers, " ", event.isAutoRepeat())
        QApplication.sendEvent(watched, as_space)
        return True


class ReusedDialog(QDialog):
    """Dialog that always opens with the focus on its default button.

    Qt would restore the previous focus when a hidden dialog opens again.
    """

    stays_on_stop = False  # True if Esc stops motors without closing the dialog

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
    """Paint `text` into an empty view, or `short` if `text` does not fit."""
    box = view.viewport().rect().adjusted(8, 4, -8, -4)
    flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    with QPainter(view.viewport()) as painter:
        painter.setPen(theme().color("muted"))
        if short and not box.contains(painter.boundingRect(box, flags, text)):
            text = short if text else ""
        painter.drawText(box, flags, text)


def strokes(painter: QPainter) -> Iterator[None]:
    """Yield once for each offset at which to draw a thin line.

    Together, the lines are one logical pixel wide. With a two-pixel pen, drawing a noisy curve
    would take a hundred times as long.
    """
    base = painter.worldTransform()
    if not base.m22():  # the device cannot be painted on, as seen under Wine
        return
    ratio = painter.deviceTransform().m22() / base.m22()
    for pixel in range(max(1, round(ratio))):
        for x, y in {(pixel, 0), (0, pixel)}:
            painter.setWorldTransform(base * QTransform.fromTranslate(x / ratio, y / ratio))
            yield
    painter.setWorldTransform(base)


def name_headers(view: QAbstractItemView) -> None:
    for header in view.findChildren(QHeaderView, options=Qt.FindChildOption.FindDirectChildrenOnly):
        is_horizontal = header.orientation() is Qt.Orientation.Horizontal
        header.setAccessibleName(tr("Columns") if is_horizontal else tr("Rows"))


def reserve_space(widget: QWidget) -> None:
    """Reserve the space of a hidden widget in its layout."""
    policy = widget.sizePolicy()
    policy.setRetainSizeWhenHidden(True)
    widget.setSizePolicy(policy)


class PressMonitor(QObject):
    """Detects when a held control loses its input.

    A held control is polled, because an opening menu or dialog swallows the release of a button
    or key without any event.
    """

    lost = Signal()  # the focus or the mouse is lost, or the widget is hidden, disabled or covered

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._was_active = False
        self._timer = new_timer(self, _POLL_MS, self._on_poll)
        widget.installEventFilter(self)

    def start(self) -> None:
        if not self._timer.isActive():
            self._was_active = self._widget.isActiveWindow()
            self._timer.start()

    def end(self) -> None:
        self._timer.stop()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_disabled = event.type() == QEvent.Type.EnabledChange and not self._widget.isEnabled()
        if watched is self._widget and (event.type() in _INPUT_LOSS_EVENTS or is_disabled):
            self._lose()
        return False

    @Slot()
    def _on_poll(self) -> None:
        is_covered = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        is_inactive = self._was_active and not self._widget.isActiveWindow()
        if is_covered or is_inactive or not self._widget.isVisible():
            self._lose()

    def _lose(self) -> None:
        if self._timer.isActive():
            self.end()
            self.lost.emit()


class ConfirmButton(QPushButton):
    """Button that ignores clicks for a double-click interval after it appears.

    Therefore, a double click cannot press a button that its first click makes appear.
    """

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self._appeared = -inf  # seconds; time at which the button appeared or changed its function

    @property
    def accepts_clicks(self) -> bool:
        return now() - self._appeared > QApplication.doubleClickInterval() / 1000

    def hold_off(self) -> None:
        """Ignore clicks again. Call this when the button's function changes."""
        self._appeared = now()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if not event.spontaneous():
            self.hold_off()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self.accepts_clicks:
            super().mousePressEvent(event)


class RedButton(QPushButton):
    """Stop button that acts on press, not on release. It is never a default button."""

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

    The hold ends when the input is lost (`PressMonitor`) or the mouse leaves the button. The user
    must then press again, even if the mouse returns with the mouse button still pressed.
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
        if self.is_held:  # otherwise Qt would press the button again when the mouse returns
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
    """Return a `wheelEvent` that acts only on a focused widget. Otherwise the page scrolls."""

    def wheel_event(widget: WidgetT, event: QWheelEvent) -> None:
        if widget.hasFocus():
            turn(widget, event)
        else:
            event.ignore()

    return wheel_event


def only_when_visible(slot: Callable[[WidgetT], None]) -> Callable[[WidgetT], None]:
    """Run a slot only while its widget is visible. `showEvent` must also call the slot."""

    @wraps(slot)
    def guarded(widget: WidgetT) -> None:
        if widget.isVisible():
            slot(widget)

    return guarded


def commit_typed() -> None:
    """Commit the text typed into the focused spin box or cell.

    An editor commits its text when it loses the focus. A shortcut or a menu does not take the
    focus, and on a Mac, neither does a button.
    """
    box = QApplication.focusWidget()
    viewport = box.parentWidget() if box is not None else None
    view = viewport.parentWidget() if viewport is not None else None
    if isinstance(view, QAbstractItemView) and view.viewport() is viewport:
        view.setFocus()  # makes the editor of a cell commit its text
    elif isinstance(box, QAbstractSpinBox):
        box.interpretText()
