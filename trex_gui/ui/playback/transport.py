"""Playback controls."""

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QLocale, QSignalBlocker, Qt, Slot
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QLabel, QSlider, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.accessible import Spoken, SpokenRange

if TYPE_CHECKING:  # numpy takes as long to load as the window
    from trex_gui.ui.playback.player import RecordingPlayer

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)

_STEPS_PER_SECOND = 100  # slider steps per second, similar to the sample rate


class _TimeSlider(QSlider, Spoken):
    spoken_role = QAccessible.Role.Slider

    def __init__(self, time_label: QLabel, parent: QWidget) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._time_label = time_label

    def spoken_state(self) -> str:
        return self._time_label.text()

    def spoken_range(self) -> SpokenRange:
        return SpokenRange(0, self.value() / _STEPS_PER_SECOND, self.maximum() / _STEPS_PER_SECOND)

    def set_spoken_value(self, value: float) -> None:
        self.setValue(round(value * _STEPS_PER_SECOND))


class TransportBar(QWidget):
    """Controls for the position and speed of a playback.

    An arrow key moves the position by 1 s. A page key moves it by 10 s.
    """

    def __init__(
        self, playback: "RecordingPlayer[Any, Any, Any]", parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._playback = playback

        self._play = ui.button(self, "playButton", on_click=self.toggle)
        self._time = ui.label(self, "timeLabel")
        self._slider = ui.named(
            _TimeSlider(self._time, self), "timeSlider", accessible=tr("Time in the recording")
        )
        self._slider.setSingleStep(_STEPS_PER_SECOND)
        self._slider.setPageStep(10 * _STEPS_PER_SECOND)
        speeds, title = [(f"{Number(speed):g} ×", speed) for speed in SPEEDS], tr("Playback speed")
        self._speed = ui.combo_box(self, "speedCombo", title, tip=title, items=speeds)
        self._speed.setCurrentIndex(SPEEDS.index(1.0))
        ui.row(self._play, (self._slider, 1), self._time, self._speed, into=self, margins=0)

        self._slider.valueChanged.connect(self._on_slid)
        self._speed.currentIndexChanged.connect(self._on_speed_selected)
        playback.moved.connect(self._on_moved)
        playback.progressed.connect(self._on_progressed)
        playback.playing_changed.connect(self._on_playing_changed)
        self._on_progressed()
        self._on_playing_changed()

    @Slot()
    def toggle(self) -> None:
        if self._playback.playing:
            self._playback.pause()
        else:
            self._playback.play()

    @Slot(int)
    def _on_speed_selected(self, index: int) -> None:
        self._playback.speed = SPEEDS[index]

    @Slot(int)
    def _on_slid(self, value: int) -> None:
        playback = self._playback
        if value == self._slider.maximum():
            playback.set_position(playback.end)
        else:
            playback.set_position(playback.start + value / _STEPS_PER_SECOND)

    @Slot()
    def _on_moved(self) -> None:
        playback = self._playback
        with QSignalBlocker(self._slider):
            self._slider.setValue(round((playback.position - playback.start) * _STEPS_PER_SECOND))
        now = time_text(playback.position - playback.start, tenths=True)
        self._time.setText(f"{now} / {time_text(playback.end - playback.start, tenths=True)}")

    @Slot()
    def _on_progressed(self) -> None:
        length = self._playback.end - self._playback.start
        # A slider is limited to 2**31 - 1 steps, or 248 days.
        with QSignalBlocker(self._slider):
            self._slider.setMaximum(min(2**31 - 1, round(length * _STEPS_PER_SECOND)))
        self._play.setEnabled(length > 0)
        self._on_moved()

    @Slot()
    def _on_playing_changed(self) -> None:
        playing = self._playback.playing
        self._play.setText(tr("&Pause") if playing else tr("&Play"))
        set_icon(self._play, "pause" if playing else "run")


def size_text(size: int) -> str:
    kind = QLocale.DataSizeFormat.DataSizeSIFormat
    return QLocale().formattedDataSize(size, 1 if size >= 1_000_000 else 0, kind)


def time_text(seconds: float, *, tenths: bool = False) -> str:
    """Format seconds as `0:01:05` or `0:01:05.3`."""
    count = int(seconds * 10 + 1e-6)
    whole, part = divmod(count, 10)
    text = f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"
    return f"{text}.{part}" if tenths else text
