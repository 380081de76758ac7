"""Stop by Esc in every window, and warning about an unconfirmed stop."""

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Slot
from PySide6.QtGui import QGuiApplication, QKeyEvent, QWindow
from PySide6.QtWidgets import QAbstractItemView, QApplication, QDialog, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.notifier import Answer
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.messages import InlinePrompt

_LOG_OUT_S = 60.0  # seconds for which a log-out counts as the reason for closing the window


def stop_or_close_dialog(device_manager: DeviceManager) -> None:
    """Stop the motors and close the active dialog.

    If a dialog is active, stop the motors only if a device `needs_stop`.
    """
    dialog, needs_stop = QApplication.activeWindow(), device_manager.needs_stop
    if needs_stop or not isinstance(dialog, QDialog):
        device_manager.press_stop()
    stays = isinstance(dialog, ReusedDialog) and dialog.stays_on_stop
    if isinstance(dialog, QDialog) and not (needs_stop and stays):
        dialog.reject()


class EscapeWatch(QObject):
    """Event filter that stops the motors on Esc.

    Modal dialogs would block a shortcut, and table editors would consume the key. The filter sees
    the key before any widget. It watches only native windows, so that few events pass through
    Python.

    If Esc closes a dialog, a question, a menu, a list or a table editor, it stops the motors only
    while they may be moving.
    """

    def __init__(
        self, app: QGuiApplication, device_manager: DeviceManager, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._manager = device_manager
        app.focusWindowChanged.connect(self._on_focus_window_changed)
        self._on_focus_window_changed(app.focusWindow())

    @Slot(QWindow)
    def _on_focus_window_changed(self, window: QWindow | None) -> None:
        if window is not None:
            window.removeEventFilter(self)
            window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Escape:
            return False
        if event.type() == QEvent.Type.ShortcutOverride and _escape_closes_widget():
            event.accept()  # Esc then arrives as a key press, not as the shortcut of the menu
            return True
        is_pressed = event.type() == QEvent.Type.KeyPress and not event.isAutoRepeat()
        closes = _escape_closes_widget() or isinstance(QApplication.activeWindow(), QDialog)
        if is_pressed and (not closes or self._manager.needs_stop):
            self._manager.press_stop()
        return False


def _escape_closes_widget() -> bool:
    """Return whether Esc closes a menu, a list, a question or a table editor."""
    if QApplication.activePopupWidget() is not None:
        return True
    focus = QApplication.focusWidget()
    parent = None if focus is None or focus.isWindow() else focus.parentWidget()
    while parent is not None and not isinstance(parent, QAbstractItemView | InlinePrompt):
        parent = None if parent.isWindow() else parent.parentWidget()
    return parent is not None


class UnconfirmedStopWarning(QObject):
    """Warns about an unconfirmed stop when the user closes the window.

    The warning does not block, so other events can still end the program. The window closes once
    the stop is confirmed or the user closes it again. At a log-out, it is not shown.
    """

    def __init__(
        self, device_manager: DeviceManager, question: InlinePrompt, window: QWidget
    ) -> None:
        super().__init__(window)
        self._manager = device_manager
        self._question = question
        self._window = window
        self.is_shown = False  # True while the warning is visible
        self._log_out_at: float | None = None
        app = QApplication.instance()
        if isinstance(app, QApplication):
            app.commitDataRequest.connect(self.record_log_out)

    @property
    def is_due(self) -> bool:
        """True if closing requires the warning. Read this after all lines are closed."""
        is_log_out = self._log_out_at is not None and now() - self._log_out_at < _LOG_OUT_S
        return bool(self._manager.unconfirmed_stop) and not self.is_shown and not is_log_out

    @Slot()
    def record_log_out(self) -> None:
        self._log_out_at = now()

    def show(self) -> None:
        text = self._manager.unconfirmed_stop
        self.is_shown = True
        self._window.setWindowState(self._window.windowState() & ~Qt.WindowState.WindowMinimized)
        self._window.activateWindow()
        self._question.prompt(
            text,
            Answer("closeUnstopped", tr("Close the window"), self._window.close),
            is_valid=lambda: self._manager.unconfirmed_stop == text,
            on_withdrawn=self._on_withdrawn,
        )

    def _on_withdrawn(self) -> None:
        if self._manager.is_idle and not self._manager.unconfirmed_stop:
            QTimer.singleShot(0, self._window.close)
        else:
            self.is_shown = False
