"""The axes of curves over time: what stands at them, and which values they reach."""

import math
from collections.abc import Iterable

from PySide6.QtCore import QCoreApplication

from trex_gui.ui.plotting.axis_ticks import AutoRange, round_up, ticks
from trex_gui.ui.widgets.bar import MINUS

Labels = list[tuple[float, str]]

_TIME_STEPS = (
    *(0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0),
    *(60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0),
)
_MOST_TIME_TICKS = 7

_FULL = 127.0
"""The greatest speed and the greatest remapped channel: plain counts seldom go further."""


class ValueAxis:
    """An axis for one unit; plain counts have one of -127 to 127 that holds still."""

    def __init__(self, unit: str) -> None:
        self.unit = unit
        self._range = AutoRange()

    def fit(self, extremes: Iterable[tuple[float, float]]) -> None:
        """Reach over these lowest and highest values; without any it stays as it is."""
        known = list(extremes)
        if known:
            self._range.include(min(low for low, _ in known), max(high for _, high in known))

    @property
    def _counts(self) -> bool:
        return not self.unit and max(self._range.high, -self._range.low) <= 200

    @property
    def ends(self) -> tuple[float, float]:
        """The values at the bottom and the top, without the margin."""
        return (-_FULL, _FULL) if self._counts else (self._range.low, self._range.high)

    @property
    def reach(self) -> tuple[float, float]:
        """The values at the edges of the picture: a margin keeps lines at the ends visible."""
        low, high = self.ends
        margin = (high - low) * 0.012
        return low - margin, high + margin

    def labels(self) -> Labels:
        """Return the values to be marked and their texts; the highest has the unit."""
        low, high = self.ends
        if self._counts:
            marked = [-_FULL, -64.0, 0.0, 64.0, _FULL]
        else:
            marked = ticks(low, high, round_up((high - low) / 5.5))
        texts = [f"{value:g}".replace("-", MINUS) for value in marked]
        texts[-1] = f"{texts[-1]} {self.unit}".strip()
        return list(zip(marked, texts, strict=True))

    def onto(self, other: "ValueAxis", value: float) -> float:
        """Return where a value of ours lies, in the values of another axis of the same height."""
        (low, high), (bottom, top) = self.reach, other.reach
        return bottom + (value - low) / (high - low) * (top - bottom)


def time_step(length: float) -> float:
    """Return the seconds between two marks of a time axis of this length."""
    for step in _TIME_STEPS:
        if length / step <= _MOST_TIME_TICKS:
            return step
    return round_up(length / _MOST_TIME_TICKS)


def ago_labels(length: float) -> Labels:
    """Return marks for the last seconds, counted from the right edge: `30 s` ... `now`."""
    tr = QCoreApplication.translate
    labels = []
    for x in ticks(-length, 0, time_step(length)):
        if abs(x) < 1e-9:
            text = tr("axes", "now")
        elif length >= 3600 and round(-x, 6) % 3600 == 0:
            text = tr("axes", "{n} h").format(n=f"{-x / 3600:g}")
        elif length >= 120 and round(-x, 6) % 60 == 0:
            text = tr("axes", "{n} min").format(n=f"{-x / 60:g}")
        else:
            text = tr("axes", "{n} s").format(n=f"{-x:g}")
        labels.append((x, text))
    return labels


def since_labels(start: float, end: float) -> Labels:
    """Return marks for times counted from the beginning of it all: `1:30`; x from `end`."""
    step = time_step(end - start)
    return [(time - end, clock_text(time, step)) for time in ticks(start, end, step)]


def clock_text(seconds: float, step: float = 0.001) -> str:
    """Seconds since the beginning as `1:02:03.4`, as exactly as the step between times wants."""
    digits = 0 if step >= 1 else max(0, math.ceil(-math.log10(step) - 1e-9))
    sign = MINUS if seconds < 0 else ""
    whole, part = divmod(round(abs(seconds) * 10**digits), 10**digits)
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    text = f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
    return sign + text + (f".{part:0{digits}}" if digits else "")
