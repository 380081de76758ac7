"""The row that says that something is being recorded, the same on every page."""

from pathlib import Path
from typing import Protocol

from PySide6.QtCore import QSize, Qt, SignalInstance, Slot
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget

from trex_gui.ui.playback.formats import size_text, time_text
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import icon, set_icon
from trex_gui.ui.theme.theme import theme

_INTERVAL_MS = 250


class Records(Protocol):
    """What records, whatever the device."""

    @property
    def changed(self) -> SignalInstance:
        """Told when anything of what stands below is other than it was."""
        ...

    @property
    def recording(self) -> bool:
        """Whether what comes is recorded."""
        ...

    @property
    def seconds(self) -> float:
        """How long it has been recording."""
        ...

    @property
    def size(self) -> int:
        """Bytes written so far."""
        ...

    @property
    def lost(self) -> int:
        """Records that could not be kept because the disk was too slow."""
        ...

    @property
    def path(self) -> Path | None:
        """The file that is written, or was written last."""
        ...

    def stop(self) -> None:
        """End the recording."""
        ...


class RecordIndicator(QWidget):
    """A red dot, how long, how much, into which file, and a button to end it.

    Hidden while nothing is recorded. The dot is not all that tells it: the words do.
    """

    def __init__(
        self, recorder: Records, parent: QWidget | None = None, *, prefix: str = ""
    ) -> None:
        """Show this recorder; `prefix` goes before the names that the parts are found by."""
        super().__init__(parent)
        self.setObjectName(f"{prefix}recordIndicator")
        self.setAccessibleName(self.tr("Recording"))
        self._recorder = recorder

        self._dot = QLabel(self)
        self._text = QLabel(self)
        self._text.setObjectName(f"{prefix}recordText")
        font = self._text.font()
        font.setBold(True)
        self._text.setFont(font)
        self._file = QLabel(self)
        self._file.setObjectName(f"{prefix}recordFile")
        self._file.setTextFormat(Qt.TextFormat.PlainText)
        # A long name is cut rather than making the window wide; its tool tip has all of it.
        self._file.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._stop = QPushButton(self.tr("Stop recordin&g"), self)
        self._stop.setObjectName(f"{prefix}stopRecordingButton")
        self._stop.setToolTip(self.tr("End the recording; motors and line go on as they are"))
        set_icon(self._stop, "ok")
        self._timer = runtime().timer(self)
        self._timer.setInterval(_INTERVAL_MS)

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._dot)
        layout.addWidget(self._text)
        layout.addWidget(self._file, 1)
        layout.addWidget(self._stop)

        self._stop.clicked.connect(recorder.stop)
        self._timer.timeout.connect(self._show)
        recorder.changed.connect(self._on_changed)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        recording = self._recorder.recording
        if recording and not self._timer.isActive():
            self._timer.start()
        elif not recording:
            self._timer.stop()
        self._show()
        self.setVisible(recording)

    @Slot()
    def _show(self) -> None:
        recorder = self._recorder
        text = self.tr("Recording  {0}  {1}").format(
            time_text(recorder.seconds), size_text(recorder.size)
        )
        if recorder.lost:
            text += "  " + self.tr("{0} samples lost: the disk is too slow").format(recorder.lost)
        self._text.setText(text)
        path = recorder.path
        name = path.name if path is not None else ""
        width = max(0, self._file.width())
        shown = self.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, width)
        self._file.setText(shown)
        self._file.setToolTip(str(path or ""))
        self.setAccessibleDescription(f"{text}, {name}")

    @Slot()
    def _on_theme_changed(self) -> None:
        side = self.fontMetrics().height()
        self._dot.setPixmap(icon("record", "led_red").pixmap(QSize(side, side)))
