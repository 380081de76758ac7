"""A plain plot in the theme's colours: frame, grid, ticks; what is drawn on it is others' matter.

The one file that knows pyqtgraph. Importing it takes as long as all of Qt: do so when a plot is
to be shown.
"""

from collections.abc import Sequence

import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal, Slot
from PySide6.QtGui import QFont, QFontMetrics, QPainterPath, QPen
from PySide6.QtWidgets import QGraphicsItem, QGraphicsPathItem, QVBoxLayout, QWidget

from trex_gui.ui.plotting.data.pyramid import Floats
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import MINUS

Ticks = Sequence[tuple[float, str]]


class Curve:
    """A line through points, in a named colour of the theme."""

    def __init__(self, canvas: "PlotCanvas", color: str, pen: QPen, *, smooth: bool) -> None:
        self._color = color
        self._pen = pen
        self._pen.setCosmetic(True)
        self._item = pg.PlotCurveItem(antialias=smooth, skipFiniteCheck=True)
        canvas.box.addItem(self._item, ignoreBounds=True)

    def set_points(self, x: Floats, y: Floats, *, gaps: bool = False) -> None:
        """Draw through these points; with `gaps`, those that are no number interrupt the line."""
        self._item.setData(x, y, connect="finite" if gaps else "all", skipFiniteCheck=not gaps)

    def clear(self) -> None:
        """Draw nothing."""
        self._item.setData([], [])

    def set_visible(self, visible: bool) -> None:
        """Show or hide the line."""
        self._item.setVisible(visible)

    def set_height(self, z: float) -> None:
        """Draw it above what is lower."""
        self._item.setZValue(z)

    def renew(self) -> None:
        """Take the colour of the theme as it is now."""
        self._pen.setColor(theme().color(self._color))
        self._item.setPen(self._pen)


class PlotCanvas(QWidget):
    """The plot; counts along, any value up. It cannot be moved or zoomed by accident.

    A screen reader says its `name`.

    Signals:
        arranged: the plot has another size, or its axes are others.
    """

    arranged = Signal()

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.plot = pg.PlotWidget(self, background=None)
        for part in (self.plot, self.plot.viewport()):
            part.setAccessibleName(name)
        self.plot.setMenuEnabled(False)
        self.plot.setMouseEnabled(x=False, y=False)
        self.plot.hideButtons()
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.plot.setFrameShape(self.plot.Shape.NoFrame)
        # A background that is kept may be that of the scheme before.
        self.plot.setCacheMode(self.plot.CacheModeFlag.CacheNone)
        self.plot.setMinimumSize(120, 40)
        self.box = self.plot.getViewBox()
        self.box.disableAutoRange()
        self.box.setDefaultPadding(0)
        self._grid = QGraphicsPathItem()
        self._grid.setZValue(-10)
        self.box.addItem(self._grid, ignoreBounds=True)
        self._curves: list[Curve] = []
        self._ranges = (0.0, 1.0), (0.0, 1.0)
        self._margins = (0, 0, 0)
        self._has_x_axis = True
        self._has_right_axis = False

        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.plot)

        theme().changed.connect(self._on_theme_changed)
        self.box.sigResized.connect(self._on_resized)
        self._on_theme_changed()
        self._show_fonts()

    @property
    def viewport(self) -> QWidget:
        """What receives the mouse; its pixels are those of the scene."""
        viewport: QWidget = self.plot.viewport()
        return viewport

    @property
    def frame(self) -> QRectF:
        """The inside of the plot, in pixels of the viewport."""
        return QRectF(self.box.sceneBoundingRect())

    def add_curve(
        self,
        color: str,
        width: float = 1,
        style: Qt.PenStyle = Qt.PenStyle.SolidLine,
        *,
        smooth: bool = False,
    ) -> Curve:
        """Draw a line; without smoothing it costs least."""
        # A pen that keeps its width when the axes change counts in the screen's own pixels.
        pen = QPen(Qt.GlobalColor.black, width * self.devicePixelRatioF(), style)
        curve = Curve(self, color, pen, smooth=smooth)
        curve.renew()
        self._curves.append(curve)
        return curve

    def add_item(self, item: QGraphicsItem) -> None:
        """Draw an item that counts in the units of the axes."""
        self.box.addItem(item, ignoreBounds=True)

    def add_overlay(self, item: QGraphicsItem) -> None:
        """Draw an item that counts in pixels of the viewport."""
        self.plot.scene().addItem(item)

    def set_axes(
        self, x: tuple[float, float], y: tuple[float, float], x_ticks: Ticks, y_ticks: Ticks
    ) -> None:
        """Show these ranges; an upper end below the lower one turns the axis round."""
        self._ranges = x, y
        self.box.invertY(y[1] < y[0])
        self.box.setRange(xRange=x, yRange=(min(y), max(y)), padding=0)
        self.plot.getAxis("bottom").setTicks([list(x_ticks)])
        self.plot.getAxis("left").setTicks([list(y_ticks)])
        path = QPainterPath()
        for at, _ in x_ticks:
            path.moveTo(at, y[0])
            path.lineTo(at, y[1])
        for at, _ in y_ticks:
            path.moveTo(x[0], at)
            path.lineTo(x[1], at)
        self._grid.setPath(path)
        self.arranged.emit()

    def set_right_axis(self, marks: Ticks, widest: str) -> None:
        """Mark heights, in values of the left axis, at the right too; no marks, no axis."""
        axis = self.plot.getAxis("right")
        if bool(marks) != self._has_right_axis:
            self._has_right_axis = bool(marks)
            self.plot.showAxis("right", self._has_right_axis)
            self._show_fonts()
            self._on_theme_changed()
        if marks:
            metrics = QFontMetrics(self.small_font())
            axis.setWidth(metrics.horizontalAdvance(widest) + 10)
            axis.setTicks([list(marks)])

    @property
    def right_edge(self) -> float:
        """Where the right axis ends, or the plot where there is none; in pixels."""
        if not self._has_right_axis:
            return self.frame.right()
        return self.frame.right() + float(self.plot.getAxis("right").width())

    def set_margins(self, *, left: str, top: int, right: int, x_axis: bool) -> None:
        """Leave room beside the plot: for the widest text at the left, for pixels elsewhere."""
        self._has_x_axis = x_axis
        metrics = QFontMetrics(self.small_font())
        self.plot.getAxis("left").setWidth(metrics.horizontalAdvance(left) + 10)
        bottom = self.plot.getAxis("bottom")
        bottom.setHeight(metrics.height() + 8 if x_axis else 0)
        bottom.setVisible(x_axis)
        below = 1 if x_axis else metrics.height() // 2
        self.plot.getPlotItem().layout.setContentsMargins(1, top, right, below)

    def x_of(self, count: float) -> float:
        """Return where a count lies, in pixels from the left of the viewport."""
        return float(self.box.mapViewToScene(QPointF(count, 0)).x())

    def y_of(self, value: float) -> float:
        """Return where a value lies, in pixels from the top of the viewport."""
        return float(self.box.mapViewToScene(QPointF(0, value)).y())

    def count_at(self, x: float) -> float:
        """Return the count under a pixel of the viewport."""
        frame, (low, high) = self.frame, self._ranges[0]
        return low + (x - frame.left()) / max(frame.width(), 1.0) * (high - low)

    def small_font(self) -> QFont:
        """The font of the ticks."""
        font = QFont(self.font())
        if font.pointSizeF() > 0:
            font.setPointSizeF(font.pointSizeF() * 0.9)
        return font

    def _show_fonts(self) -> None:
        for side in ("left", "bottom", "right"):
            self.plot.getAxis(side).setStyle(
                tickFont=self.small_font(),
                tickLength=0,
                tickTextOffset=6,
                hideOverlappingLabels=False,
            )

    @Slot()
    def _on_resized(self) -> None:
        self.arranged.emit()

    @Slot()
    def _on_theme_changed(self) -> None:
        color = theme().color
        self.plot.setBackground(None)
        self.box.setBackgroundColor(color("plot_background"))
        self.box.setBorder(QPen(color("plot_frame"), 1))
        grid = QPen(color("grid"), 1)
        grid.setCosmetic(True)
        self._grid.setPen(grid)
        for side in ("left", "bottom", "right"):
            axis = self.plot.getAxis(side)
            axis.setPen(QPen(Qt.PenStyle.NoPen))  # the frame is the box's border
            axis.setTickPen(QPen(color("plot_frame"), 1))
            axis.setTextPen(QPen(color("plot_text"), 1))
        for curve in self._curves:
            curve.renew()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and hasattr(self, "_grid"):
            self._show_fonts()


def signed(value: float) -> str:
    """A number as it stands at an axis."""
    return f"{value:g}".replace("-", MINUS)
