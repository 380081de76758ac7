"""Playback controls: play, time slider, speed."""

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtWidgets import QSlider, QWidget

from trex_gui.ui.playback.cursor import SPEEDS, PlaybackCursor
from trex_gui.ui.playback.formats import time_text
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets import builders

_PER_SECOND = 100
"""Slider steps per second: about the rate of the samples."""


class TransportBar(QWidget):
    """Moves the position of a recording.

    Arrow keys move by a second, page keys by ten.
    """

    def __init__(self, playback: PlaybackCursor, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._playback = playback

        self._play = builders.button(self, "playButton", on_click=self.toggle)
        self._slider = builders.named(
            QSlider(Qt.Orientation.Horizontal, self),
            "timeSlider",
            accessible=self.tr("Time in the recording"),
        )
        self._slider.setSingleStep(_PER_SECOND)
        self._slider.setPageStep(10 * _PER_SECOND)
        self._time = builders.label(self, "timeLabel")
        self._speed = builders.combo_box(
            self,
            "speedCombo",
            self.tr("Playback speed"),
            items=[(f"{speed:g} ×", speed) for speed in SPEEDS],
        )
        self._speed.setCurrentIndex(SPEEDS.index(1.0))
        builders.row(self._play, (self._slider, 1), self._time, self._speed, into=self, margins=0)

        self._slider.valueChanged.connect(self._on_slid)
        self._speed.currentIndexChanged.connect(self._on_speed_chosen)
        playback.moved.connect(self._on_moved)
        playback.progressed.connect(self._on_progressed)
        playback.playing_changed.connect(self._on_playing_changed)
        self._on_progressed()
        self._on_playing_changed()

    @Slot()
    def toggle(self) -> None:
        """Play or pause."""
        if self._playback.playing:
            self._playback.pause()
        else:
            self._playback.play()

    @Slot(int)
    def _on_slid(self, value: int) -> None:
        playback = self._playback
        if value == self._slider.maximum():
            playback.set_position(playback.end)
        else:
            playback.set_position(playback.start + value / _PER_SECOND)

    @Slot(int)
    def _on_speed_chosen(self, index: int) -> None:
        self._playback.set_speed(float(self._speed.itemData(index)))

    @Slot()
    def _on_moved(self) -> None:
        playback = self._playback
        with QSignalBlocker(self._slider):
            self._slider.setValue(round((playback.position - playback.start) * _PER_SECOND))
        now = time_text(playback.position - playback.start, tenths=True)
        self._time.setText(f"{now} / {time_text(playback.end - playback.start, tenths=True)}")

    @Slot()
    def _on_progressed(self) -> None:
        length = self._playback.end - self._playback.start
        # A slider holds 248 days.
        with QSignalBlocker(self._slider):
            self._slider.setMaximum(min(2**31 - 1, round(length * _PER_SECOND)))
        self._play.setEnabled(length > 0)
        self._on_moved()

    @Slot()
    def _on_playing_changed(self) -> None:
        playing = self._playback.playing
        self._play.setText(self.tr("&Pause") if playing else self.tr("&Play"))
        set_icon(self._play, "pause" if playing else "run")
