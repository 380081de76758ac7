"""Before the window goes: motors that may still turn."""

from PySide6.QtCore import QObject, Qt, QTimer, Slot
from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets.inline_prompt import InlinePrompt, PromptAnswer

_LOG_OUT_S = 60.0
"""Within which a window that is closed after a log-out has begun is closed by it."""


class UnconfirmedStopWarning(QObject):
    """Tells of a stop that is not proved where the window is closed, in the window.

    It asks rather than wait for an answer, so that whatever else ends the program does. A stop
    that is proved after all closes the window, as was wanted; so does whoever closes it again,
    who has read it by then. Nobody is there to read it who logs out.
    """

    def __init__(
        self, device_manager: DeviceManager, question: InlinePrompt, window: QWidget
    ) -> None:
        super().__init__(window)
        self._switchboard = device_manager
        self._question = question
        self._window = window
        self._given = False
        self._log_out_at: float | None = None
        app = QApplication.instance()
        if isinstance(app, QApplication):
            app.commitDataRequest.connect(self.note_log_out)

    @property
    def given(self) -> bool:
        """Whether it stands in the window: closing that is not to be asked about any more."""
        return self._given

    @property
    def is_due(self) -> bool:
        """Whether the window, with every line closed, must not go without it."""
        return bool(self._switchboard.unconfirmed_stop) and not self._given and not self._is_log_out

    @property
    def _is_log_out(self) -> bool:
        return self._log_out_at is not None and now() - self._log_out_at < _LOG_OUT_S

    @Slot()
    def note_log_out(self) -> None:
        """Somebody logs out."""
        self._log_out_at = now()

    def give(self) -> None:
        """Say what has to be known; the window stays until that was read."""
        text = self._switchboard.unconfirmed_stop
        self._given = True
        self._window.setWindowState(self._window.windowState() & ~Qt.WindowState.WindowMinimized)
        self._window.activateWindow()
        self._question.ask(
            text,
            PromptAnswer("closeUnstopped", self.tr("Close the window"), self._window.close),
            still=lambda: self._switchboard.unconfirmed_stop == text,
            otherwise=self._on_over,
        )

    def _on_over(self) -> None:
        """It was cancelled, or things have answered it by themselves."""
        if self._switchboard.is_idle and not self._switchboard.unconfirmed_stop:
            QTimer.singleShot(0, self._window.close)
        else:
            self._given = False
