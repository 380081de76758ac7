"""Messages to the user, from models and pages to the banner of their window."""

from PySide6.QtCore import QObject, Qt, Signal


class Notifier(QObject):
    """Carries messages to one window, which shows the newest."""

    info = Signal(str)  # what was done, in sentences for the user
    error = Signal(str)  # what was not done, and why
    # The same behind the event that is being handled: for messages that come with a report whose
    # handling clears the banner.
    delayed_info = Signal(str)
    delayed_error = Signal(str)
    cleared = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.delayed_info.connect(self.info, Qt.ConnectionType.QueuedConnection)
        self.delayed_error.connect(self.error, Qt.ConnectionType.QueuedConnection)
