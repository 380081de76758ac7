"""The live bar of a channel input, with its calibration drawn on it."""

from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.plotting.axes import spread, ticks
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import Bar, BarState

# Raw counts. Ref: Pololu TReX User's Guide 4.b: a pulse counts from 0.5 to 2.5 ms.
_USUAL = {InputSource.RC: (2000, 5500), InputSource.ANALOG: (0, 1023)}
_WIDEST = {InputSource.RC: (1250, 6250), InputSource.ANALOG: (0, 1023)}
_GROWS_BY = 250  # 100 us
_TICK_STEPS = {
    InputSource.RC: (100.0, 200.0, 500.0, 1000.0),
    InputSource.ANALOG: (0.5, 1.0, 2.5, 5.0),
}

_MARK_OVERSHOOT = 3
_POINTER_HEAD = 6


class ChannelBar(Bar):
    """Shows a raw channel value between minimum, neutral and maximum.

    The fill runs from neutral to the value, so its side shows the direction; inside the
    deadband it is grey. The axis widens for values and calibrations that lie outside it.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        self._source = InputSource.RC
        self._calibration: Calibration | None = None
        self._drawn: dict[str, int] = {}
        self._raw: int | None = None
        self._axis = _USUAL[self._source]
        super().__init__("bar", "bar_negative", parent)
        self.setAccessibleName(self.tr("Channel input"))
        self._refresh()

    def set_source(self, source: InputSource) -> None:
        """Choose pulses or voltages; the value so far was in the other unit and is dropped."""
        if source is self._source:
            return
        self._source = source
        self._raw = None
        self._heard = False
        self._axis = _USUAL[source]
        self._widen()
        self._measure()
        self._refresh()

    def set_calibration(
        self, calibration: Calibration | None, *, minimum: bool = True, maximum: bool = True
    ) -> None:
        """Draw these marks, or none; an end that is not known yet can be left out."""
        drawn: dict[str, int] = {}
        if calibration is not None and minimum:
            drawn[self.tr("min")] = calibration.minimum
        if calibration is not None:
            drawn[self.tr("neutral")] = calibration.neutral
        if calibration is not None and maximum:
            drawn[self.tr("max")] = calibration.maximum
        if calibration == self._calibration and drawn == self._drawn:
            return
        self._calibration = calibration
        self._drawn = drawn
        self._axis = _USUAL[self._source]
        self._widen()
        self._refresh()

    def set_raw(self, raw: int | None) -> None:
        """Show a count; `None` means that the channel has no valid signal."""
        if self._heard and raw == self._raw:
            return
        self._heard = True
        self._raw = raw
        self._widen()
        self._refresh()

    @property
    def marks(self) -> dict[str, int]:
        """The marks that are drawn: their names, and their counts."""
        return dict(self._drawn)

    @property
    def inset(self) -> int:
        """How far the track begins right of the widget's edge: text below it can, too."""
        return self._side()

    @property
    def axis(self) -> tuple[int, int]:
        """The raw counts at the left and the right end."""
        return self._axis

    def x_of(self, raw: float) -> float:
        """Return where a count lies, in pixels from the left of the widget."""
        track = self._track()
        low, high = self._axis
        part = min(max((raw - low) / (high - low), 0.0), 1.0)
        return track.left() + part * track.width()

    def _widen(self) -> None:
        low, high = self._axis
        shown = [] if self._raw is None else [self._raw]
        if self._calibration is not None:
            shown += [self._calibration.minimum, self._calibration.neutral]
            shown += [self._calibration.maximum]
        lowest, highest = _WIDEST[self._source]
        for count in shown:
            if count < low:
                low = max(lowest, count // _GROWS_BY * _GROWS_BY)
            if count > high:
                high = min(highest, -(-count // _GROWS_BY) * _GROWS_BY)
        self._axis = (low, high)

    def _in_deadband(self, raw: int) -> bool:
        calibration = self._calibration
        return calibration is not None and abs(raw - calibration.neutral) <= calibration.deadband

    def _forget_value(self) -> None:
        self._raw = None

    def _has_signal(self) -> bool:
        return self._raw is not None

    def _value_text(self) -> str:
        return "" if self._raw is None else self._source.text(self._raw)

    def _spoken_value(self) -> str:
        raw = self._raw
        if raw is None:
            return ""
        value = self._source.text(raw)
        calibration = self._calibration
        if calibration is None:
            return value
        if self._in_deadband(raw):
            return self.tr("{value}, neutral").format(value=value)
        distance = self._source.text(abs(raw - calibration.neutral))
        if raw > calibration.neutral:
            text = self.tr("{value}, {distance} above neutral")
        else:
            text = self.tr("{value}, {distance} below neutral")
        return text.format(value=value, distance=distance)

    def _widest_value(self) -> str:
        return self._source.text(_WIDEST[self._source][1])

    def _height(self) -> int:
        text = self._small_metrics.height()
        return 2 * text + self._track_height() + _MARK_OVERSHOOT + _POINTER_HEAD + 2

    def _track_height(self) -> int:
        return self.fontMetrics().height() + 2

    def _side(self) -> int:
        """Return the room beside the track that half a tick label takes."""
        return self._small_metrics.horizontalAdvance("0000") // 2 + 1

    def _lay_out(self) -> QRect:
        top = (self.height() - self._height()) // 2
        top += self._small_metrics.height() + _MARK_OVERSHOOT
        width = self.width() - 2 * self._side() - self._value_column()
        return QRect(self._side(), top + 1, max(width, 1), self._track_height())

    def _look(self) -> tuple[object, ...]:
        return (self._source, self._calibration, tuple(self._drawn), self._axis)

    def _paint_static(self, painter: QPainter, track: QRect) -> None:
        painter.setFont(self._small)
        painter.setPen(self._marks.muted)
        self._paint_ticks(painter, track)
        if self._calibration is not None:
            if self.state is BarState.LIVE:
                self._paint_deadband(painter, track, self._calibration)
            self._paint_marks(painter, track)
            painter.setPen(self._marks.text)
            self._paint_mark_labels(painter, track)
        painter.setFont(self.font())

    def _paint_ticks(self, painter: QPainter, track: QRect) -> None:
        source, metrics = self._source, self._small_metrics
        low, high = (source.physical(count) for count in self._axis)
        gap = metrics.averageCharWidth() * 1.2
        unit = f" {source.unit}"
        # The unit may reach under the number, but not out of the widget.
        end = float(self.width() - self._value_column() / 2)
        for step in _TICK_STEPS[source]:
            values = ticks(low, high, step)
            texts = [f"{value:g}" for value in values]
            texts[-1] += unit
            xs = [self.x_of(value * source.counts_per_unit) for value in values]
            widths = [float(metrics.horizontalAdvance(text)) for text in texts]
            if sum(widths) + gap * len(widths) > track.width():
                continue
            wanted = [*xs[:-1], xs[-1] + metrics.horizontalAdvance(unit) / 2]
            centres = spread(wanted, widths, 0.0, end, gap)
            if centres is None:
                continue
            # The digits are under the tick, the unit beside them.
            bottom = track.top() + track.height()
            for x, centre, width, text in zip(xs, centres, widths, texts, strict=True):
                painter.fillRect(QRectF(self._snap(x), bottom + 1, 1, 3), self._marks.muted)
                where = QRectF(centre - width / 2, bottom + _POINTER_HEAD, width + 1, 0)
                where.setHeight(metrics.height())
                painter.drawText(where, Qt.AlignmentFlag.AlignCenter, text)
            return

    def _paint_deadband(self, painter: QPainter, track: QRect, calibration: Calibration) -> None:
        left = self._snap(self.x_of(calibration.neutral - calibration.deadband))
        right = self._snap(self.x_of(calibration.neutral + calibration.deadband))
        if right <= left:
            return
        painter.fillRect(
            QRectF(left, track.top(), right - left, track.height()), theme().color("deadband")
        )
        for x in (left, right - 1):
            painter.fillRect(QRectF(x, track.top(), 1, track.height()), self._marks.neutral)

    def _paint_marks(self, painter: QPainter, track: QRect) -> None:
        for count in self._drawn.values():
            x = self._snap(self.x_of(count) - 0.5)
            painter.fillRect(
                QRectF(x, track.top() - _MARK_OVERSHOOT, 1, track.height() + _MARK_OVERSHOOT),
                self._marks.mark,
            )

    def _paint_mark_labels(self, painter: QPainter, track: QRect) -> None:
        low, high = self._axis
        metrics = self._small_metrics
        names, counts = self._drawn.keys(), self._drawn.values()
        texts = [
            f"◂ {name}" if count < low else f"{name} ▸" if count > high else name
            for name, count in zip(names, counts, strict=True)
        ]
        if list(counts) != sorted(counts):  # the board takes no such calibration
            return
        widths = [float(metrics.horizontalAdvance(text)) for text in texts]
        xs = [self.x_of(count) for count in counts]
        gap = metrics.averageCharWidth() * 0.8
        end = float(track.left() + track.width() + self._side())
        centres = spread(xs, widths, 0.0, end, gap)
        if centres is None:  # too narrow for all: the ends alone, as far as there are two
            texts, xs, widths = texts[::2], xs[::2], widths[::2]
            centres = spread(xs, widths, 0.0, end, gap) or []
        top = track.top() - _MARK_OVERSHOOT - metrics.height()
        for centre, width, text in zip(centres, widths, texts, strict=False):
            where = QRectF(centre - width / 2, top, width + 1, metrics.height())
            painter.drawText(where, Qt.AlignmentFlag.AlignCenter, text)

    def _paint_live(self, painter: QPainter, track: QRect) -> None:
        raw = self._raw
        if raw is None:
            return
        x = self.x_of(raw)
        if self._calibration is not None:
            self._paint_way(painter, track, self._calibration, raw)
            self._paint_marks(painter, track)
        self._paint_pointer(painter, track, x, _POINTER_HEAD)

    def _paint_way(
        self, painter: QPainter, track: QRect, calibration: Calibration, raw: int
    ) -> None:
        """Fill from neutral to the value: grey as far as the deadband goes, coloured beyond."""
        neutral, deadband = calibration.neutral, calibration.deadband
        start = self.x_of(neutral)
        if self._in_deadband(raw):
            self._paint_fill(painter, track, start, self.x_of(raw), self._marks.neutral)
            return
        above = raw > neutral
        edge = self.x_of(neutral + deadband if above else neutral - deadband)
        color = self._marks.fill if above else self._marks.negative
        self._paint_fill(painter, track, start, edge, self._marks.neutral)
        self._paint_fill(painter, track, edge, self.x_of(raw), color)
