"""Stopping from the window: Esc in every window, and the warning about an unconfirmed stop."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Slot
from PySide6.QtGui import QGuiApplication, QKeyEvent, QWindow
from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets.inline_prompt import InlinePrompt, PromptAnswer

_LOG_OUT_S = 60.0
"""Seconds after the start of a log-out within which closing the window is part of it."""


class EscapeWatch(QObject):
    """Event filter that stops on Esc before any widget gets the key.

    A shortcut is not enough: modal dialogs block it and editors in a table consume the key. The
    filter is installed on the native windows, so only their events pass through Python.
    """

    def __init__(self, app: QGuiApplication, stop: Callable[[], None], parent: QObject) -> None:
        super().__init__(parent)
        self._stop = stop
        app.focusWindowChanged.connect(self._on_focus_window_changed)
        self._on_focus_window_changed(app.focusWindow())

    @Slot(QWindow)
    def _on_focus_window_changed(self, window: QWindow | None) -> None:
        if window is not None:
            window.removeEventFilter(self)
            window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        del watched
        if (
            event.type() == QEvent.Type.KeyPress
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
            and not event.isAutoRepeat()
        ):
            self._stop()
        return False


class UnconfirmedStopWarning(QObject):
    """Warns in the window about an unconfirmed stop when the window is closed.

    It does not block, so that anything else can still end the program. A stop that is confirmed
    after all closes the window, and so does closing it again. There is no warning on log-out.
    """

    def __init__(
        self, device_manager: DeviceManager, question: InlinePrompt, window: QWidget
    ) -> None:
        super().__init__(window)
        self._manager = device_manager
        self._question = question
        self._window = window
        self.given = False
        self._log_out_at: float | None = None
        app = QApplication.instance()
        if isinstance(app, QApplication):
            app.commitDataRequest.connect(self.note_log_out)

    @property
    def is_due(self) -> bool:
        """Whether the window, with every line closed, must not close without it."""
        return bool(self._manager.unconfirmed_stop) and not self.given and not self._is_log_out

    @property
    def _is_log_out(self) -> bool:
        return self._log_out_at is not None and now() - self._log_out_at < _LOG_OUT_S

    @Slot()
    def note_log_out(self) -> None:
        """Note that the user logs out."""
        self._log_out_at = now()

    def give(self) -> None:
        """Show the warning; the window stays open."""
        text = self._manager.unconfirmed_stop
        self.given = True
        self._window.setWindowState(self._window.windowState() & ~Qt.WindowState.WindowMinimized)
        self._window.activateWindow()
        self._question.ask(
            text,
            PromptAnswer("closeUnstopped", self.tr("Close the window"), self._window.close),
            still=lambda: self._manager.unconfirmed_stop == text,
            otherwise=self._on_over,
        )

    def _on_over(self) -> None:
        """Close the window if the stop was confirmed; else the warning was cancelled."""
        if self._manager.is_idle and not self._manager.unconfirmed_stop:
            QTimer.singleShot(0, self._window.close)
        else:
            self.given = False
