"""The input of a channel over the last seconds."""

import math
from collections.abc import Iterable

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QPolygonF, QTransform
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import strokes
from trex_gui.ui.widgets.painted import Painted, Painter

STRIP_SECONDS = 10.0
_MAX_GAP = 0.5  # seconds without a sample that interrupt the line
_MARGIN = 0.03  # of the height, above and below: lines at the ends of the axis remain visible


class InputStrip(Painted):
    """Draws raw counts upwards and time to the right, where the newest sample is.

    Qt keeps the points: a frame adds the new samples and costs a twentieth of a millisecond.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._axis = 0, 1
        self._calibration: Calibration | None = None
        self._newest = -math.inf  # time at the right edge
        self._is_broken = True  # the next point begins a line
        self.lines: list[QPolygonF] = []  # of points (time, count); gaps are between them
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        theme().changed.connect(self.update)

    def set_scale(self, axis: tuple[int, int], calibration: Calibration | None) -> None:
        """Set the counts at bottom and top, and whose neutral, ends and deadband are marked."""
        if (axis, calibration) != (self._axis, self._calibration):
            self._axis, self._calibration = axis, calibration
            self.update()

    def add_samples(self, times: Iterable[float], counts: Iterable[float]) -> None:
        """Add samples that are newer than those before; NaN is a gap."""
        for time, count in zip(times, counts, strict=True):
            if math.isnan(count):
                self._is_broken = True
            else:
                if self._is_broken or time - self._newest > _MAX_GAP:
                    self.lines.append(QPolygonF())
                self.lines[-1].append(QPointF(time, count))
                self._is_broken = False
            self._newest = time
        self._drop_before(self._newest - STRIP_SECONDS)
        self.update()

    def _drop_before(self, oldest: float) -> None:
        while self.lines:
            line = self.lines[0]
            while not line.isEmpty() and line.first().x() < oldest:
                line.removeFirst()
            if not line.isEmpty():
                return
            del self.lines[0]

    def clear(self) -> None:
        self.lines.clear()
        self._newest, self._is_broken = -math.inf, True
        self.update()

    def spoken_state(self) -> str:
        counts = [point.y() for line in self.lines for point in line.toList()]
        if not counts:
            return tr("no signal")
        return tr("{0:.0f} to {1:.0f} counts").format(min(counts), max(counts))

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 30, self.fontMetrics().height() * 3)

    def minimumSizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 10, self.fontMetrics().height() * 2)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        color = theme().color
        box = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        with Painter(self, smooth=False) as painter:
            painter.fillRect(box, color("plot_background" if self.lines else "track_off"))
            if self.lines:
                painter.setClipRect(box)
                place = self._place(box)
                self._paint_marks(painter, place, box)
                painter.setWorldTransform(place)
                pen = QPen(color("pointer"), 1)
                pen.setCosmetic(True)
                painter.setPen(pen)
                for _ in strokes(painter):
                    for line in self.lines:
                        painter.drawPolyline(line)
                painter.resetTransform()
                painter.setClipping(False)
            painter.setPen(QPen(color("plot_frame"), 1))
            painter.drawRect(box)

    def _place(self, box: QRectF) -> QTransform:
        """Return the transformation from times and counts to pixels."""
        low, high = self._axis
        margin = (high - low) * _MARGIN
        place = QTransform.fromTranslate(box.right(), box.bottom())
        place.scale(box.width() / STRIP_SECONDS, -box.height() / (high - low + 2 * margin))
        return place.translate(-self._newest, margin - low)

    def _paint_marks(self, painter: QPainter, place: QTransform, box: QRectF) -> None:
        calibration = self._calibration
        if calibration is None:
            return

        def level(count: int, height: float = 1) -> QRectF:
            return QRectF(box.left(), round(place.map(QPointF(0, count)).y()), box.width(), height)

        middle, deadband = calibration.neutral, calibration.deadband
        band = level(middle + deadband)
        band.setBottom(level(middle - deadband).top())
        painter.fillRect(band, theme().color("deadband"))
        for count in (calibration.minimum, middle, calibration.maximum):
            painter.fillRect(level(count), theme().color("grid"))
