"""Messages to the user, from models and pages to the banner of their window."""

from PySide6.QtCore import QObject, Qt, Signal


class Notifier(QObject):
    """Carries messages to one window, which shows the newest.

    Signals:
        info, error: what was done, and what was not and why; sentences for the user.
        delayed_info, delayed_error: the same behind the event that is being handled; for messages
            that come with a report whose handling clears the banner.
        cleared: the messages so far no longer apply.
    """

    info = Signal(str)
    error = Signal(str)
    delayed_info = Signal(str)
    delayed_error = Signal(str)
    cleared = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.delayed_info.connect(self.info, Qt.ConnectionType.QueuedConnection)
        self.delayed_error.connect(self.error, Qt.ConnectionType.QueuedConnection)
