"""Curves drawn for a file: axes, limits, events and a legend with figures, in either scheme.

It is painted anew rather than copied from the screen: as large as wanted, on a light ground when
a dark window is open, and as lines in an SVG.
"""

from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPen, QPolygonF
from PySide6.QtSvg import QSvgGenerator

from trex_gui.ui.plotting.axes import ValueAxis, since_labels
from trex_gui.ui.plotting.data.traces import TraceInfo, Traces
from trex_gui.ui.plotting.marks import COLOURS, MOST_MARKS, places, word_of
from trex_gui.ui.plotting.number_format import charge_text, value_text
from trex_gui.ui.theme.theme import Colours

SIZE = QSize(1200, 700)
_BINS = 1000
_SCALE = 2
"""Pixels of a PNG for each unit of `SIZE`: sharp on paper and on fine screens."""


class Picture:
    """One picture of a source from `start` to `end` with the curves named in `shown`."""

    def __init__(
        self,
        source: Traces,
        span: tuple[float, float],
        shown: frozenset[str],
        colours: Colours,
        origin: float,
    ) -> None:
        self._source = source
        self._start, self._end = span
        self._traces = [trace for trace in source.traces if trace.name in shown]
        self._colours = colours
        self._origin = origin

    def write(self, path: Path) -> bool:
        """Write an SVG or PNG, as the name ends; return whether that went well."""
        if path.suffix.lower() == ".svg":
            return self._write_svg(path)
        image = QImage(SIZE * _SCALE, QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(_SCALE)
        with QPainter(image) as painter:
            self.paint(painter)
        return image.save(str(path))

    def _write_svg(self, path: Path) -> bool:
        generator = QSvgGenerator()
        generator.setFileName(str(path))
        generator.setSize(SIZE)
        generator.setViewBox(QRectF(0, 0, SIZE.width(), SIZE.height()))
        generator.setTitle(self._title())
        painter = QPainter()
        if not painter.begin(generator):
            return False
        self.paint(painter)
        return painter.end()

    def _title(self) -> str:
        return QCoreApplication.translate("Picture", "Curves, time in minutes and seconds")

    def _color(self, name: str) -> QColor:
        return self._colours.named.get(name) or self._colours.palette[name]

    def paint(self, painter: QPainter) -> None:
        """Draw it, `SIZE` large."""
        font = QFont(painter.font())
        font.setPixelSize(15)
        painter.setFont(font)
        metrics = QFontMetricsF(font)
        line = metrics.height()
        page = QRectF(0, 0, SIZE.width(), SIZE.height())
        painter.fillRect(page, self._color("base"))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        bottom = page.height() - 2 * line - (len(self._traces) + 0.5) * line
        frame = QRectF(70, 2 * line, page.width() - 140, bottom - 2 * line)

        units = [trace.unit for trace in self._source.traces]
        axes = ValueAxis(units[0]), ValueAxis(next((u for u in units if u != units[0]), ""))
        lines = []
        extremes: tuple[list[tuple[float, float]], ...] = ([], [])
        for trace in self._traces:
            times, values = self._source.points(trace.name, self._start, self._end, _BINS)
            if np.isfinite(values).any():
                side = int(trace.unit != axes[0].unit)
                extremes[side].append((float(np.nanmin(values)), float(np.nanmax(values))))
                lines.append((trace, axes[side], times, values))
        for axis, found in zip(axes, extremes, strict=True):
            axis.fit(found)

        painter.fillRect(frame, self._color("plot_background"))
        self._paint_axes(painter, frame, axes, has_right=bool(extremes[1]))
        self._paint_events(painter, frame, line)
        painter.setClipRect(frame)
        for trace, axis, times, values in lines:
            color = self._color(trace.color)
            limit = self._source.limits.get(trace.name)
            if limit is not None:
                painter.setPen(QPen(color, 1.2, Qt.PenStyle.DashLine))
                y = _y(frame, axis, limit)
                painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y))
            style = Qt.PenStyle.SolidLine if axis is axes[0] else Qt.PenStyle.DotLine
            painter.setPen(QPen(color, 1.3, style))
            whole = np.flatnonzero(~np.isfinite(values))
            for part_times, part in zip(
                np.split(times, whole), np.split(values, whole), strict=True
            ):
                known = np.isfinite(part)
                points = [
                    QPointF(self._x(frame, float(time)), _y(frame, axis, float(value)))
                    for time, value in zip(part_times[known], part[known], strict=True)
                ]
                painter.drawPolyline(QPolygonF(points))
        painter.setClipping(False)
        self._paint_legend(painter, frame.bottom() + 2 * line, line)

    def _x(self, frame: QRectF, time: float) -> float:
        share = (time - self._start) / (self._end - self._start)
        return frame.left() + share * frame.width()

    def _paint_axes(
        self,
        painter: QPainter,
        frame: QRectF,
        axes: tuple[ValueAxis, ValueAxis],
        *,
        has_right: bool,
    ) -> None:
        grid, text = QPen(self._color("grid"), 1), QPen(self._color("plot_text"), 1)
        middle = Qt.AlignmentFlag.AlignVCenter
        for value, label in axes[0].labels():
            y = _y(frame, axes[0], value)
            painter.setPen(grid)
            painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y))
            painter.setPen(text)
            box = QRectF(0, y - 10, frame.left() - 8, 20)
            painter.drawText(box, middle | Qt.AlignmentFlag.AlignRight, label)
        for value, label in axes[1].labels() if has_right else []:
            box = QRectF(frame.right() + 8, _y(frame, axes[1], value) - 10, 70, 20)
            painter.drawText(box, middle | Qt.AlignmentFlag.AlignLeft, label)
        for ago, label in since_labels(self._start - self._origin, self._end - self._origin):
            x = self._x(frame, self._end + ago)
            painter.setPen(grid)
            painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()))
            painter.setPen(text)
            box = QRectF(x - 60, frame.bottom() + 4, 120, 20)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, label)
        painter.setPen(QPen(self._color("plot_frame"), 1))
        painter.drawRect(frame)

    def _paint_events(self, painter: QPainter, frame: QRectF, line: float) -> None:
        events = self._source.events_between(self._start, self._end)[-MOST_MARKS:]
        xs = [self._x(frame, event.time) for event in events]
        metrics = QFontMetricsF(painter.font())
        widths = [metrics.horizontalAdvance(word_of(event.kind)) + 4 for event in events]
        lefts = places(xs, widths, SIZE.width())
        unnamed = len(events) - len(lefts)
        for row, (event, x) in enumerate(zip(events, xs, strict=True)):
            color = self._color(COLOURS[event.kind])
            painter.setPen(QPen(color, 1, Qt.PenStyle.DotLine))
            painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()))
            if row >= unnamed:
                painter.setPen(color)
                box = QRectF(lefts[row - unnamed], frame.top() - line - 2, widths[row], line)
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word_of(event.kind))

    def _paint_legend(self, painter: QPainter, top: float, line: float) -> None:
        """Name each curve with its figures: a picture says little without them."""
        for row, trace in enumerate(self._traces):
            y = top + row * line
            style = Qt.PenStyle.SolidLine if trace.unit else Qt.PenStyle.DotLine
            painter.setPen(QPen(self._color(trace.color), 2, style))
            painter.drawLine(QPointF(70, y + line / 2), QPointF(100, y + line / 2))
            painter.setPen(self._color("text"))
            place = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
            painter.drawText(QRectF(110, y, 180, line), place, trace.label)
            painter.drawText(QRectF(290, y, 900, line), place, self._figures(trace))

    def _figures(self, trace: TraceInfo) -> str:
        found = self._source.statistics(trace.name, self._start, self._end)
        if not found.seconds:
            return ""
        tr, unit = QCoreApplication.translate, trace.unit
        parts = [
            tr("Picture", "low {0}").format(value_text(found.low, unit)),
            tr("Picture", "peak {0}").format(value_text(found.high, unit)),
            tr("Picture", "mean {0}").format(value_text(found.mean, unit)),
            tr("Picture", "RMS {0}").format(value_text(found.rms, unit)),
        ]
        if trace.unit == "A":
            parts.append(tr("Picture", "charge {0}").format(charge_text(found)))
            limit = self._source.limits.get(trace.name)
            if limit is not None:
                parts.append(tr("Picture", "limit {0}").format(value_text(limit, unit)))
        return ", ".join(parts)


def _y(frame: QRectF, axis: ValueAxis, value: float) -> float:
    low, high = axis.reach
    return frame.bottom() - (value - low) / (high - low) * frame.height()
