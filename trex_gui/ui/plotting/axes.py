"""Axes of plots: ranges, labels, and the visible span of time."""

import math
from collections.abc import Sequence
from itertools import accumulate

from trex_gui.core.translation import Number, tr
from trex_gui.ui.widgets.bar import MINUS

Labels = list[tuple[float, str]]  # values on an axis, with their texts
_TIME_STEPS = (
    *(0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0),
    *(60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0),
)
_MAX_TIME_LABELS = 7

FULL_COUNTS = 127.0  # largest speed and largest value of a remapped channel
_MIN_LIMIT = 1.0
_SHRINK_BELOW = 0.8  # an axis shrinks if its values fit into this fraction of a smaller range
MIN_SPAN = 0.05  # seconds; four samples of currents
MAX_SPAN = 4 * 3600.0  # seconds; longer than a full history


def round_up(value: float) -> float:
    """Round a positive value up to 1, 2 or 5 times a power of ten."""
    decade = 10.0 ** math.floor(math.log10(value))
    # Without a tolerance, 0.3 - 0.1 would be rounded up to 0.5.
    return next((s * decade for s in (1, 2, 5) if value <= s * decade * (1 + 1e-9)), 10 * decade)


def ticks(low: float, high: float, step: float) -> list[float]:
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [n * step for n in range(first, last + 1)]


def spread(
    centers: Sequence[float], widths: Sequence[float], low: float, high: float, gap: float
) -> list[float] | None:
    """Move labels apart. Return their centres, or `None` if the space is too small.

    `centers` must be sorted. `low`, `high`: limits for the edges of the labels.
    """
    space = high - low - sum(widths) - gap * max(0, len(widths) - 1)
    if space < 0:
        return None
    # Centres of the labels packed from `low`. Shifts must not decrease from label to label.
    packed = [low + sum(widths[:n]) + gap * n + width / 2 for n, width in enumerate(widths)]
    offsets = (center - lowest for center, lowest in zip(centers, packed, strict=True))
    shifts = [min(max(offset, 0), space) for offset in offsets]
    from_below = accumulate(shifts, max)
    from_above = reversed([*accumulate(reversed(shifts), min)])
    pairs = zip(packed, from_below, from_above, strict=True)
    return [lowest + (below + above) / 2 for lowest, below, above in pairs]


class ValueAxis:
    """Axis for one unit, always including 0.

    The axis grows at once and shrinks with hysteresis. Its limits are 1, 2 or 5 times a power of
    ten. An axis of plain counts extends from -127 to 127, unless values exceed this range.
    """

    def __init__(self, unit: str, top: float | None = None) -> None:
        """`top`: fixed upper limit. By default, the axis fits the values."""
        self.unit = unit
        self._top = top
        self._low, self._high = 0.0, top or _MIN_LIMIT
        self._largest = top or 0.0  # largest magnitude of the values

    def fit(self, extremes: Sequence[tuple[float, float]]) -> None:
        """Fit the axis to pairs of lowest and highest values. Without pairs, do nothing."""
        if extremes and self._top is None:
            self._high = _fitted_end(self._high, max(high for _, high in extremes))
            lowest = min(low for low, _ in extremes)
            self._largest = max(-lowest, *(high for _, high in extremes))
            self._low = 0.0 - _fitted_end(-self._low, -lowest)  # avoids -0
            if self._high == self._low == 0:
                self._high = _MIN_LIMIT

    @property
    def _is_fixed(self) -> bool:
        return not self.unit and self._largest <= FULL_COUNTS

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest value, without a margin."""
        return (-FULL_COUNTS, FULL_COUNTS) if self._is_fixed else (self._low, self._high)

    @property
    def reach(self) -> tuple[float, float]:
        """Values at the edges of the plot: `ends` with a margin."""
        low, high = self.ends
        margin = (high - low) * 0.012
        return low - margin, high + margin

    def labels(self, limit: int) -> Labels:
        """Return labels at round values. On a short axis, return labels only at the ends.

        `limit`: number of labels that fit. There are never more than six. The last label has the
        unit.
        """
        low, high = self.ends
        if limit < 5 and (limit < 2 or self._is_fixed):
            return value_labels([low, high], self.unit)
        if self._is_fixed:
            return count_labels()
        step = round_up((high - low) / (min(limit, 6) - 0.5))
        return value_labels(ticks(low, high, step), self.unit)

    def map_to(self, other: "ValueAxis", value: float) -> float:
        """Return the value on another axis at the height of `value`."""
        (low, high), (bottom, top) = self.reach, other.reach
        return bottom + (value - low) / (high - low) * (top - bottom)


def _fitted_end(current: float, needed: float) -> float:
    if needed <= 0:
        return 0.0
    if needed > current:
        return max(_MIN_LIMIT, round_up(needed))
    return min(current, max(_MIN_LIMIT, round_up(needed / _SHRINK_BELOW)))


def count_labels() -> Labels:
    return value_labels([-FULL_COUNTS, -64.0, 0.0, 64.0, FULL_COUNTS], "")


def value_labels(values: Sequence[float], unit: str) -> Labels:
    texts = [f"{Number(value):g}".replace("-", MINUS) for value in values]
    if texts:
        texts[-1] = f"{texts[-1]} {unit}".strip()
    return list(zip(values, texts, strict=True))


def time_step(length: float) -> float:
    steps = (step for step in _TIME_STEPS if length / step <= _MAX_TIME_LABELS)
    return next(steps, round_up(length / _MAX_TIME_LABELS))


def duration_text(seconds: float) -> str:
    if seconds < 60:
        return tr("{n} s").format(n=f"{Number(seconds):.3g}")
    if seconds < 3600:
        return tr("{n} min").format(n=f"{Number(seconds / 60):.3g}")
    return tr("{n} h").format(n=f"{Number(seconds / 3600):.3g}")


def ago_labels(length: float) -> Labels:
    """Return labels for the last `length` seconds, such as `30 s` to `now`."""
    marks = ticks(-length, 0, time_step(length))
    return [(x, tr("now") if abs(x) < 1e-9 else duration_text(-x)) for x in marks]


def since_labels(start: float, end: float) -> Labels:
    """Return labels for times since the origin, such as `1:30`. Positions are relative to `end`."""
    step = time_step(end - start)
    return [(time - end, clock_text(time, step)) for time in ticks(start, end, step)]


def clock_text(seconds: float, step: float = 0.001) -> str:
    """Format seconds as `1:02:03.4`, with the decimals that `step` needs."""
    digits = 0 if step >= 1 else max(0, math.ceil(-math.log10(step) - 1e-9))
    sign = MINUS if seconds < 0 else ""
    whole, part = divmod(round(abs(seconds) * 10**digits), 10**digits)
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    text = f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
    return sign + text + (f".{part:0{digits}}" if digits else "")


class Span:
    """Visible part of the time axis, in seconds. A live span follows the newest sample."""

    def __init__(self, length: float = 30.0) -> None:
        self.length = self._live_length = length
        self._end = self._oldest = self._newest = 0.0
        self.live = True

    @property
    def start(self) -> float:
        return self.end - self.length

    @property
    def end(self) -> float:
        return self._newest if self.live else self._end

    def set_available(self, oldest: float, newest: float) -> None:
        self._oldest, self._newest = oldest, newest

    def set_length(self, seconds: float) -> None:
        """Set the length. The right edge does not move."""
        self.length = min(max(seconds, MIN_SPAN), MAX_SPAN)

    def select_length(self, seconds: float) -> None:
        """Set the length of this view and of the next live view."""
        self.set_length(seconds)
        self._live_length = self.length

    def freeze(self) -> None:
        if self.live:
            self._end, self._live_length, self.live = self._newest, self.length, False

    def go_live(self) -> None:
        """Follow the newest sample, with the length of the last live view."""
        if not self.live:
            self.length, self.live = self._live_length, True

    def show(self, start: float, end: float) -> None:
        """Freeze the view between two times, in either order."""
        self.freeze()
        middle = (start + end) / 2
        self.set_length(abs(end - start))
        self._end = middle + self.length / 2

    def zoom(self, factor: float, around: float) -> None:
        """Multiply the length. A live span keeps its right edge.

        In a frozen span, the time `around` does not move.
        """
        fraction = (self.end - around) / self.length
        self.set_length(self.length * factor)
        if not self.live:
            self._end = around + fraction * self.length
            self._limit_end()

    def pan(self, seconds: float) -> None:
        """Freeze the view and move it. A negative number moves it to earlier times."""
        self.freeze()
        self._end += seconds
        self._limit_end()

    def _limit_end(self) -> None:
        # At least a tenth of the plot shows samples.
        part = self.length / 10
        self._end = max(self._oldest + part, min(self._end, self._newest + self.length - part))
