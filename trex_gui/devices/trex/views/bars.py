"""The live bars: a channel's input with its calibration, and an output."""

from collections.abc import Iterable

from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.plotting.axes import Labels, ticks, value_labels
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import SpokenRange
from trex_gui.ui.widgets.bar import Bar, BarState

# Raw counts. Ref: Pololu TReX User's Guide 4.b: a pulse counts from 0.5 to 2.5 ms.
USUAL_AXIS = {InputSource.RC: (2000, 5500), InputSource.ANALOG: (0, 1023)}
_WIDEST = {InputSource.RC: (1250, 6250), InputSource.ANALOG: (0, 1023)}
_GROWS_BY = 250  # 100 us
_STEPS = {  # between two labels of an axis, in µs and V
    InputSource.RC: (100.0, 200.0, 500.0, 1000.0, 2000.0),
    InputSource.ANALOG: (0.5, 1.0, 2.5, 5.0, 10.0),
}
_MARK_OVERSHOOT = 3
_ZERO_OVERSHOOT = 2


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
    """Paint a raw count as the way from neutral, between marks; `None`: no signal, not known."""
    color, radius = theme().color, track.height() / 2

    def x_of(value: int) -> float:
        low, high = axis
        return track.left() + track.width() * min(max((value - low) / (high - low), 0.0), 1.0)

    painter.setPen(QPen(color("hairline"), 1))
    painter.setBrush(color("track"))
    painter.drawRoundedRect(track, radius, radius)
    if calibration is None:
        return
    if count is not None:
        left, right = sorted((x_of(calibration.neutral), x_of(count)))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color("bar"))
        painter.drawRoundedRect(QRectF(left, track.top(), right - left, track.height()), 2, 2)
    painter.setPen(QPen(color("mark"), 1))
    for mark in (calibration.minimum, calibration.neutral, calibration.maximum):
        x = x_of(mark)
        painter.drawLine(QPointF(x, track.top() - 3), QPointF(x, track.bottom() + 3))


class ChannelBar(Bar):
    """A raw value between minimum, neutral and maximum; the axis widens for what lies outside."""

    inset = 1  # pixels from the left edge to the track

    def __init__(self, parent: QWidget | None = None) -> None:
        self._source = InputSource.RC
        self._calibration: Calibration | None = None
        self._raw: int | None = None
        self.marks: dict[str, int] = {}  # names and counts of the marks that are drawn
        self.axis = USUAL_AXIS[self._source]  # raw counts at the left and the right end
        super().__init__("bar", parent)
        self.setAccessibleName(tr("Channel input"))
        self._refresh()

    def set_source(self, source: InputSource) -> None:
        """Choose pulses or voltages; the value so far was in the other unit and is dropped."""
        if source is not self._source:
            self._source = source
            self._raw = None
            self._has_value = False
            self.axis = USUAL_AXIS[source]
            self._widen()
            self._measure()
            self._refresh()

    def set_calibration(
        self, calibration: Calibration | None, *, minimum: bool = True, maximum: bool = True
    ) -> None:
        """Draw these marks, or none; an end that is not known yet can be left out."""
        marks: dict[str, int] = {}
        if calibration is not None:
            lowest = {tr("min"): calibration.minimum} if minimum else {}
            highest = {tr("max"): calibration.maximum} if maximum else {}
            marks = lowest | {tr("neutral"): calibration.neutral} | highest
        if (calibration, marks) != (self._calibration, self.marks):
            self._calibration, self.marks = calibration, marks
            self.axis = USUAL_AXIS[self._source]
            self._widen()
            self._refresh()

    def set_raw(self, raw: int | None) -> None:
        """Show a count; `None` means that the channel has no valid signal."""
        if not self._has_value or raw != self._raw:
            self._has_value = True
            self._raw = raw
            self._widen()
            self._refresh()

    def x_of(self, raw: float) -> float:
        """Return where a count lies, in pixels from the left of the widget."""
        return _x_on(self._track(), self.axis, raw)

    def _widen(self) -> None:
        shown = [] if self._raw is None else [self._raw]
        if (calibration := self._calibration) is not None:
            shown += [calibration.minimum, calibration.neutral, calibration.maximum]
        lowest, highest = _WIDEST[self._source]
        self.axis = widened(self.axis, (min(max(count, lowest), highest) for count in shown))

    def _in_deadband(self, raw: int) -> bool:
        calibration = self._calibration
        return calibration is not None and abs(raw - calibration.neutral) <= calibration.deadband

    def _clear(self) -> None:
        self._raw = None

    def _has_signal(self) -> bool:
        return self._raw is not None

    def _value_text(self) -> str:
        return "" if self._raw is None else self._source.text(self._raw)

    def _spoken_value(self) -> str:
        raw, calibration, value = self._raw, self._calibration, self._value_text()
        if raw is None or calibration is None:
            return value
        if self._in_deadband(raw):
            return tr("{value}, neutral").format(value=value)
        distance = self._source.text(abs(raw - calibration.neutral))
        if raw > calibration.neutral:
            text = tr("{value}, {distance} above neutral")
        else:
            text = tr("{value}, {distance} below neutral")
        return text.format(value=value, distance=distance)

    def spoken_range(self) -> SpokenRange:
        """Return µs or V."""
        low, high = self.axis
        return SpokenRange(*map(self._source.physical, (low, self._raw or low, high)))

    def _widest_value(self) -> str:
        return self._source.text(_WIDEST[self._source][1])

    def _height(self) -> int:
        return self.fontMetrics().height() + 2 * _MARK_OVERSHOOT

    def _lay_out(self) -> QRect:
        width, height = self.width() - self._value_column() - 3, self.fontMetrics().height() - 4
        return QRect(self.inset, (self.height() - height) // 2, max(width, 1), height)

    def _cache_key(self) -> tuple[object, ...]:
        return (self._source, self._calibration, tuple(self.marks), self.axis)

    def _paint_static(self, painter: QPainter, track: QRect) -> None:
        if (calibration := self._calibration) is not None:
            if self.state is BarState.LIVE:
                middle, reach = calibration.neutral, calibration.deadband
                left, right = self.x_of(middle - reach), self.x_of(middle + reach)
                self._paint_fill(painter, track, left, right, theme().color("deadband"))
            self._paint_marks(painter, track)

    def _paint_marks(self, painter: QPainter, track: QRect) -> None:
        top, height = track.top() - _MARK_OVERSHOOT, track.height() + 2 * _MARK_OVERSHOOT
        for count in self.marks.values():
            x = self._snap(self.x_of(count) - 0.5)
            painter.fillRect(QRectF(x, top, 1, height), self._marks.mark)

    def _paint_live(self, painter: QPainter, track: QRect) -> None:
        raw, calibration = self._raw, self._calibration
        if raw is None:
            return
        if calibration is not None:
            start, end = self.x_of(calibration.neutral), self.x_of(raw)
            color = self._marks.neutral if self._in_deadband(raw) else self._marks.fill
            self._paint_fill(painter, track, start, end, color)
            self._paint_marks(painter, track)
        self._paint_pointer(painter, track, self.x_of(raw))


class OutputBar(Bar):
    """Shows -127 to 127 from the centre; `None` is no valid signal."""

    def __init__(self, parent: QWidget | None = None) -> None:
        self.value: float | None = None
        super().__init__("bar", parent)
        self._refresh()
        self.setAccessibleName(tr("Output"))

    def set_value(self, value: float | None) -> None:
        if not self._has_value or value != self.value:
            self._has_value = True
            self.value = value
            self._refresh()

    def x_of(self, value: float) -> float:
        """Return where a value lies, in pixels from the left of the widget."""
        return _x_on(self._track(), self._axis(), value)

    def _axis(self) -> tuple[float, float]:
        return -FULL_SCALE, FULL_SCALE

    def spoken_range(self) -> SpokenRange:
        low, high = self._axis()
        return SpokenRange(low, self.value or 0, high)

    def _clear(self) -> None:
        self.value = None

    def _has_signal(self) -> bool:
        return self.value is not None

    def _height(self) -> int:
        return self.fontMetrics().height() + 2 + 2 * _ZERO_OVERSHOOT + 2

    def _lay_out(self) -> QRect:
        height = self.fontMetrics().height() + 2
        width = self.width() - self._value_column() - 3
        return QRect(1, (self.height() - height) // 2, max(width, 1), height)

    def _paint_static(self, painter: QPainter, track: QRect) -> None:
        if not self._caption():
            self._paint_line(painter, track, 0, self._marks.mark)

    def _paint_line(self, painter: QPainter, track: QRect, value: float, color: QColor) -> None:
        x = self._snap(self.x_of(value) - 0.5)
        top, height = track.top() - _ZERO_OVERSHOOT, track.height() + 2 * _ZERO_OVERSHOOT
        painter.fillRect(QRectF(x, top, 1, height), color)

    def _paint_live(self, painter: QPainter, track: QRect) -> None:
        value = self.value
        if value is not None:
            self._paint_fill(painter, track, self.x_of(0), self.x_of(value), self._marks.fill)
            self._paint_line(painter, track, 0, self._marks.mark)
            self._paint_pointer(painter, track, self.x_of(value))

    def _value_text(self) -> str:
        return "" if self.value is None else signed_text(int(self.value))

    def _spoken_value(self) -> str:
        return tr("{value} of {full}").format(value=self._value_text(), full=FULL_SCALE)

    def _widest_value(self) -> str:
        return signed_text(-FULL_SCALE)


def _x_on(track: QRect, axis: tuple[float, float], value: float) -> float:
    low, high = axis
    return track.left() + min(max((value - low) / (high - low), 0.0), 1.0) * track.width()
