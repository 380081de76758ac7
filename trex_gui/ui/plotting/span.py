"""Which part of the time is shown: the newest seconds, or a part that a person chose."""

LEAST = 0.05
"""Seconds shown at least: four samples of currents."""

MOST = 4 * 3600.0
"""Seconds shown at most; a full history is shorter."""


class Span:
    """A part of the time axis, in seconds; it follows the newest sample while `live`.

    Pure: knows no clock, only the oldest and the newest time it is told.
    """

    def __init__(self, length: float = 30.0) -> None:
        self._length = length
        self._end = 0.0
        self._oldest = 0.0
        self._newest = 0.0
        self.live = True

    @property
    def length(self) -> float:
        """How many seconds are shown."""
        return self._length

    @property
    def start(self) -> float:
        """The time at the left edge."""
        return self.end - self._length

    @property
    def end(self) -> float:
        """The time at the right edge."""
        return self._newest if self.live else self._end

    def take(self, oldest: float, newest: float) -> None:
        """Take what there is to be shown."""
        self._oldest, self._newest = oldest, newest

    def set_length(self, seconds: float) -> None:
        """Show so many seconds; the right edge stays where it is.

        Raises:
            ValueError: it is not more than 0.
        """
        if seconds <= 0:
            raise ValueError(f"a window of {seconds} s shows nothing")
        self._length = min(max(seconds, LEAST), MOST)

    def hold(self) -> None:
        """Stay where it is from now on."""
        self._end = self.end
        self.live = False

    def go_live(self) -> None:
        """Follow the newest sample."""
        self.live = True

    def show(self, start: float, end: float) -> None:
        """Show from one time to another, in either order, and stay there."""
        start, end = min(start, end), max(start, end)
        middle = (start + end) / 2
        self.set_length(max(end - start, LEAST))
        self._end = middle + self._length / 2
        self.live = False

    def zoom(self, factor: float, around: float) -> None:
        """Show `factor` times as much; `around` stays where it is on the screen.

        While live the right edge stays the newest sample.
        """
        before = self._length
        share = (self.end - around) / before
        self.set_length(before * factor)
        if not self.live:
            self._end = around + share * self._length
            self._keep_in_reach()

    def pan(self, seconds: float) -> None:
        """Show what is so much later (or earlier, below 0), and stay there."""
        self.hold()
        self._end += seconds
        self._keep_in_reach()

    def _keep_in_reach(self) -> None:
        """Leave a tenth of the picture to what there is."""
        part = self._length / 10
        self._end = max(self._oldest + part, min(self._end, self._newest + self._length - part))
