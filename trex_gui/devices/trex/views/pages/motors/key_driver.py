"""Driving with held arrow keys or WASD."""

from PySide6.QtCore import QEvent, QObject, Qt, Slot
from PySide6.QtGui import QGuiApplication, QKeyEvent, QWindow
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QTextEdit,
    QWidget,
)

from trex_gui.devices.trex.model.momentary_drive import Heading, MomentaryDrive, keys_setpoint
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.widgets.behaviour import PressMonitor

_HEADINGS: dict[int, Heading] = {
    Qt.Key.Key_Up: Heading.FORWARD,
    Qt.Key.Key_W: Heading.FORWARD,
    Qt.Key.Key_Down: Heading.BACK,
    Qt.Key.Key_S: Heading.BACK,
    Qt.Key.Key_Left: Heading.LEFT,
    Qt.Key.Key_A: Heading.LEFT,
    Qt.Key.Key_Right: Heading.RIGHT,
    Qt.Key.Key_D: Heading.RIGHT,
}
_KEY_WIDGETS = (  # widgets that use arrow keys and letters themselves
    *(QLineEdit, QAbstractSpinBox, QTextEdit, QPlainTextEdit),
    *(QAbstractItemView, QComboBox),
)
_MODIFIERS = Qt.KeyboardModifier
_COMMAND_MODIFIERS = _MODIFIERS.ControlModifier | _MODIFIERS.AltModifier | _MODIFIERS.MetaModifier
_CHANGING_KEYS: set[int] = {  # keys that change the names of other keys
    *(Qt.Key.Key_Shift, Qt.Key.Key_Control, Qt.Key.Key_Alt, Qt.Key.Key_Meta, Qt.Key.Key_AltGr),
    *(Qt.Key.Key_CapsLock, Qt.Key.Key_NumLock, Qt.Key.Key_ScrollLock, Qt.Key.Key_Mode_switch),
    *(Qt.Key.Key_Super_L, Qt.Key.Key_Super_R, Qt.Key.Key_Hyper_L, Qt.Key.Key_Hyper_R),
}
_REPEAT_MS = 20  # X11 delivers the press of a repeated key within this time after its release


class KeyDriver(QObject):
    """Event filter that receives the keys of the page's window before the widgets do.

    While `enabled` is true, keys drive wherever the focus is, except in fields, tables and lists.
    While the pad has the focus, keys always drive.

    A key is identified by its scan code, since the layout or Num Lock may change its name between
    press and release. The release of an unknown key, or a key such as Shift, releases all keys.

    On X11, a held key repeats as a release and a press with the same timestamp. Qt often handles
    the release before it has received the press, and then marks neither event as a repeat.
    Without a short wait for the press, the motors would occasionally brake while a key is held.
    """

    def __init__(self, drive: MomentaryDrive, motors: Motors, page: QWidget, pad: QWidget) -> None:
        super().__init__(page)
        self._drive = drive
        self._motors = motors
        self._page = page
        self._pad = pad
        self.enabled = False
        self._keys: dict[int, Heading] = {}  # scan code of each pressed key → heading
        self._modifiers = Qt.KeyboardModifier.NoModifier
        self._watch = PressMonitor(page)
        # True if a key repeat arrives as a release and a press
        self.has_split_repeats = QGuiApplication.platformName() == "xcb"
        self._released = 0, 0  # scan code and time of the last release, which may be a repeat
        self._repeat_timer = new_timer(
            self, _REPEAT_MS, self._on_release_confirmed, single_shot=True
        )

        self._watch.lost.connect(self.release)
        motors.holder_changed.connect(self._on_holder_changed)
        app = QApplication.instance()
        if isinstance(app, QApplication):
            app.focusWindowChanged.connect(self._on_focus_window_changed)
            app.focusChanged.connect(self._on_focus_changed)
            self._on_focus_window_changed(app.focusWindow())

    @Slot(bool)
    def set_enabled(self, enabled: bool) -> None:
        self.enabled = enabled
        if not enabled:
            self.release()

    @Slot()
    def release(self) -> None:
        self._clear()
        self._drive.release()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent):
            if event.type() == QEvent.Type.KeyPress:
                return self._on_pressed(event)
            if event.type() == QEvent.Type.KeyRelease:
                return self._on_released(event)
        return False

    def _on_pressed(self, event: QKeyEvent) -> bool:
        if self._repeat_timer.isActive():
            if (_scan_code(event), event.timestamp()) == self._released:
                self._repeat_timer.stop()
                return True
            self._on_release_confirmed()
        if self._keys and (_modifiers(event) != self._modifiers or event.key() in _CHANGING_KEYS):
            self.release()
        heading = _HEADINGS.get(event.key())
        if heading is None or event.modifiers() & _COMMAND_MODIFIERS or not self._can_drive():
            return False
        if not event.isAutoRepeat():
            self._modifiers = _modifiers(event)
            self._keys[_scan_code(event)] = heading
            self._steer()
        return True

    def _on_released(self, event: QKeyEvent) -> bool:
        if event.isAutoRepeat():
            return event.key() in _HEADINGS and bool(self._keys)
        if not self._keys:
            return False
        if self._repeat_timer.isActive():
            self._on_release_confirmed()
        scan_code = _scan_code(event)
        is_known = scan_code in self._keys
        if not is_known or _modifiers(event) != self._modifiers:
            self.release()
            return is_known
        self._released = scan_code, event.timestamp()
        if self.has_split_repeats:
            self._repeat_timer.start()
        else:
            self._on_release_confirmed()
        return True

    @Slot()
    def _on_release_confirmed(self) -> None:
        self._repeat_timer.stop()
        self._keys.pop(self._released[0], None)
        if self._keys:
            self._steer()
        else:
            self.release()

    def _can_drive(self) -> bool:
        if not self._motors.armed or not self._page.isVisible():
            return False
        if QApplication.activePopupWidget() or QApplication.activeModalWidget():
            return False
        return self._drives_with_focus(QApplication.focusWidget())

    def _drives_with_focus(self, focus: QWidget | None) -> bool:
        return focus is self._pad or (self.enabled and not isinstance(focus, _KEY_WIDGETS))

    def _steer(self) -> None:
        forward, turn = keys_setpoint(self._keys.values())
        if self._drive.steer(forward, turn):
            self._watch.start()
        else:
            self._clear()

    def _clear(self) -> None:
        self._keys.clear()
        self._repeat_timer.stop()
        self._watch.end()

    @Slot()
    def _on_holder_changed(self) -> None:
        if self._keys and not self._drive.held:
            self._clear()

    @Slot(QWindow)
    def _on_focus_window_changed(self, window: QWindow | None) -> None:
        own = self._page.window().windowHandle()
        if window is not None and window is own:
            window.removeEventFilter(self)
            window.installEventFilter(self)
        elif self._keys:
            self.release()

    @Slot(QWidget, QWidget)
    def _on_focus_changed(self, _old: QWidget | None, new: QWidget | None) -> None:
        if self._keys and not self._drives_with_focus(new):
            self.release()


def _scan_code(event: QKeyEvent) -> int:
    """Return the negative scan code of a key, or the `Qt.Key` if there is no scan code."""
    scan_code = event.nativeScanCode()
    return -scan_code if scan_code else event.key()


def _modifiers(event: QKeyEvent) -> Qt.KeyboardModifier:
    return event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
