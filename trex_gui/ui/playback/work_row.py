"""The row that says how far a file is read or written, with a button that ends it."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QPushButton, QWidget


class WorkRow(QWidget):
    """Hidden while nothing is done.

    Signals:
        cancelled: a person wants no more of it.
    """

    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._progress = QProgressBar(self)
        self._progress.setObjectName("recordingProgress")
        self._progress.setAccessibleName(self.tr("Progress"))
        self._cancel = QPushButton(self.tr("&Cancel"), self)
        self._cancel.setObjectName("cancelRecordingButton")
        self._cancel.setToolTip(self.tr("Read or write no further"))

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._progress, 1)
        layout.addWidget(self._cancel)

        self._cancel.clicked.connect(self.cancelled)

    def show_share(self, share: float | None, words: str) -> None:
        """Show how much is done, 0 to 1, in words with `%p` for it; `None` where nothing is."""
        self.setVisible(share is not None)
        if share is not None:
            self._progress.setValue(round(100 * share))
            self._progress.setFormat(words)
