"""A position in a recording, moved by the user or by playing."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.ui.runtime import now, runtime

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Playback speeds."""

_FRAME_MS = 33


class PlaybackCursor(QObject):
    """A position between `start` and `end`; all times are on the session's clock (s).

    Signals:
        progressed: `end` may have changed.
        moved: `position`.
        playing_changed: `playing` or `speed`.
    """

    progressed = Signal()
    moved = Signal()
    playing_changed = Signal()

    def __init__(self, start: float, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.start = self.end = self.position = start
        self.speed = 1.0
        self._timer = runtime().timer(self)
        self._timer.setInterval(_FRAME_MS)
        self._last_frame = 0.0

        self._timer.timeout.connect(self._on_frame)

    @property
    def is_loaded(self) -> bool:
        """Whether `end` is known."""
        raise NotImplementedError

    @property
    def playing(self) -> bool:
        return self._timer.isActive()

    def set_position(self, time: float) -> None:
        """Move to the nearest time within the recording."""
        time = max(self.start, min(self.end, time))
        if time != self.position:
            self.position = time
            self.moved.emit()

    def play(self) -> None:
        """Play on; from the start again at the end."""
        if self.position >= self.end:
            self.set_position(self.start)
        self._last_frame = now()
        self._timer.start()
        self.playing_changed.emit()

    def pause(self) -> None:
        if self.playing:
            self._timer.stop()
            self.playing_changed.emit()

    def set_speed(self, speed: float) -> None:
        """Set a positive playback speed; 1 is real time."""
        if speed <= 0:
            raise ValueError(f"playback speed {speed} is not positive")
        self.speed = speed
        self.playing_changed.emit()

    def advance(self, seconds: float) -> None:
        """Play for so many seconds of real time."""
        self.set_position(self.position + seconds * self.speed)
        if self.position >= self.end and self.is_loaded:
            self.pause()

    @Slot()
    def _on_frame(self) -> None:
        before, self._last_frame = self._last_frame, now()
        self.advance(self._last_frame - before)
