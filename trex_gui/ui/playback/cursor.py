"""A place in a recording that a person moves, or that moves by itself."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.ui.runtime import now, runtime

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""How many times as fast as it happened a recording can be played."""

_FRAME_MS = 33


class PlaybackCursor(QObject):
    """A time between `start` and `end`; whoever derives from it says how far they are known.

    Signals:
        progressed: `end` may be another one.
        moved: `position`.
        playing_changed: `playing` or `speed`.
    """

    progressed = Signal()
    moved = Signal()
    playing_changed = Signal()

    def __init__(self, start: float, parent: QObject | None = None) -> None:
        """Stand at the start, on the session's clock (s)."""
        super().__init__(parent)
        self._start = self._end = self._position = start
        self._speed = 1.0
        self._playing = runtime().timer(self)
        self._playing.setInterval(_FRAME_MS)
        self._frame_at = 0.0

        self._playing.timeout.connect(self._on_frame)

    @property
    def is_loaded(self) -> bool:
        """Whether `end` is known."""
        raise NotImplementedError

    @property
    def start(self) -> float:
        """When it begins on the session's clock."""
        return self._start

    @property
    def end(self) -> float:
        """When it ends on the session's clock; when it begins, before that is known."""
        return self._end

    @property
    def position(self) -> float:
        """The place that is looked at, on the session's clock."""
        return self._position

    @property
    def playing(self) -> bool:
        """Whether the place moves by itself."""
        return self._playing.isActive()

    @property
    def speed(self) -> float:
        """How many times as fast as it happened it plays."""
        return self._speed

    def set_position(self, time: float) -> None:
        """Look at a time of the session's clock, or at the nearest that was recorded."""
        time = max(self._start, min(self._end, time))
        if time != self._position:
            self._position = time
            self.moved.emit()

    def play(self) -> None:
        """Let the place move; from the start again when it is at the end."""
        if self._position >= self._end:
            self.set_position(self._start)
        self._frame_at = now()
        self._playing.start()
        self.playing_changed.emit()

    def pause(self) -> None:
        """Let the place stand."""
        if self._playing.isActive():
            self._playing.stop()
            self.playing_changed.emit()

    def set_speed(self, speed: float) -> None:
        """Play so many times as fast as it happened."""
        if speed <= 0:
            raise ValueError(f"a recording cannot be played {speed} times as fast")
        self._speed = speed
        self.playing_changed.emit()

    def advance(self, seconds: float) -> None:
        """Let so many seconds pass for whoever watches."""
        self.set_position(self._position + seconds * self._speed)
        if self._position >= self._end and self.is_loaded:
            self.pause()

    @Slot()
    def _on_frame(self) -> None:
        before, self._frame_at = self._frame_at, now()
        self.advance(self._frame_at - before)
