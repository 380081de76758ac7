"""The live bars: a channel's input with its calibration, and an output."""

from collections.abc import Iterable

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.plotting.axes import Labels, ticks, value_labels
from trex_gui.ui.widgets.accessible import SpokenRange
from trex_gui.ui.widgets.bar import Bar, BarState, paint_track

# Raw counts. Ref: Pololu TReX User's Guide 4.b: a pulse counts from 0.5 to 2.5 ms.
USUAL_AXIS = {InputSource.RC: (2000, 5500), InputSource.ANALOG: (0, 1023)}
_GROWS_BY = 250  # 100 us
_STEPS = {  # between two labels of an axis, in µs and V
    InputSource.RC: (100.0, 200.0, 500.0, 1000.0, 2000.0),
    InputSource.ANALOG: (0.5, 1.0, 2.5, 5.0, 10.0),
}


def input_axis(
    source: InputSource, calibration: Calibration | None, count: int | None = None
) -> tuple[int, int]:
    """Return the ends of an axis for these marks and this count."""
    counts = [] if count is None else [count]
    if calibration is not None:
        counts += [calibration.minimum, calibration.maximum]
    return widened(USUAL_AXIS[source], counts)


def widened(axis: tuple[int, int], counts: Iterable[int]) -> tuple[int, int]:
    """Return the ends of an axis, moved in round steps to include these counts."""
    low, high = axis
    for count in counts:
        if count < low:
            low = max(0, count // _GROWS_BY * _GROWS_BY)
        if count > high:
            high = -(-count // _GROWS_BY) * _GROWS_BY
    return low, high


def input_labels(source: InputSource, axis: tuple[int, int], most: int) -> Labels:
    """Return at most that many labels, in counts; the last has the unit."""
    low, high = (source.physical(count) for count in axis)
    for step in _STEPS[source]:
        values = ticks(low, high, step)
        if len(values) <= most:
            break
    labels = value_labels(values, source.unit)
    return [(value * source.counts_per_unit, text) for value, text in labels]


def paint_input(
    painter: QPainter,
    track: QRectF,
    axis: tuple[int, int],
    count: int | None,
    calibration: Calibration | None,
) -> None:
    """Paint a raw count and the marks of its calibration; `None`: no signal, not known."""
    marks: tuple[int, ...] = ()
    fill = "bar"
    if calibration is not None:
        marks = calibration.minimum, calibration.neutral, calibration.maximum
        if count is not None and abs(count - calibration.neutral) <= calibration.deadband:
            fill = "neutral"
    paint_track(painter, track, axis, count, marks, fill=fill)


class ChannelBar(Bar):
    """A raw count between minimum, neutral and maximum; the axis widens for what lies outside."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(USUAL_AXIS[InputSource.RC], parent)
        self._source = InputSource.RC
        self._calibration: Calibration | None = None

    def set_scale(self, source: InputSource, calibration: Calibration | None) -> None:
        """Set the unit and the marks; a value in the other unit is dropped."""
        if source is not self._source and self.value is not None:
            self._show(BarState.WAITING, None)
        if (source, calibration) != (self._source, self._calibration):
            self._source, self._calibration = source, calibration
            self.axis = input_axis(source, calibration, self.value)
            self.update()

    def set_value(self, value: int | None) -> None:
        if value is not None:
            self.axis = widened(self.axis, (value,))
        super().set_value(value)

    def text_of(self, value: int) -> str:
        return self._source.text(value)

    def spoken_value(self, value: int) -> str:
        text, calibration = self.text_of(value), self._calibration
        if calibration is None:
            return text
        offset = value - calibration.neutral
        if abs(offset) <= calibration.deadband:
            return tr("{value}, neutral").format(value=text)
        beside = tr("{value}, {distance} below neutral")
        if offset > 0:
            beside = tr("{value}, {distance} above neutral")
        return beside.format(value=text, distance=self.text_of(abs(offset)))

    def spoken_range(self) -> SpokenRange:
        """Return µs or V."""
        low, high = self.axis
        return SpokenRange(*map(self._source.physical, (low, self.value or low, high)))

    def paint(self, painter: QPainter, track: QRectF) -> None:
        paint_input(painter, track, self.axis, self.value, self._calibration)


class OutputBar(Bar):
    """A value from -127 to 127, from the centre."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__((-FULL_SCALE, FULL_SCALE), parent)

    def text_of(self, value: int) -> str:
        return signed_text(value)

    def spoken_value(self, value: int) -> str:
        return tr("{value} of {full}").format(value=self.text_of(value), full=FULL_SCALE)

    def spoken_range(self) -> SpokenRange:
        return SpokenRange(-FULL_SCALE, self.value or 0, FULL_SCALE)

    def paint(self, painter: QPainter, track: QRectF) -> None:
        paint_track(painter, track, self.axis, self.value, (0,))
