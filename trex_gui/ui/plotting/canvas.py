"""Plot area in the theme's colours: axes, grid, shapes and mouse events.

Import this module lazily. It is the only module that imports pyqtgraph, which takes as long to
load as Qt.
"""

from typing import Any, TypeVar

import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal, Slot
from PySide6.QtGui import QBrush, QFont, QFontMetrics, QPainter, QPainterPath, QPen
from PySide6.QtWidgets import QGraphicsItem, QGraphicsPathItem, QWidget

from trex_gui.ui.plotting.axes import Labels
from trex_gui.ui.plotting.history import Floats
from trex_gui.ui.theme.theme import scaled_font, theme
from trex_gui.ui.widgets.behaviour import strokes
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.painted import never_mirror

_LABEL_MARGIN = 60  # pixels; a label may extend past the end of its axis by this much
_ZOOM = 0.8  # factor per notch of the mouse wheel


pg.setConfigOption("mouseRateLimit", -1)  # otherwise pyqtgraph drops fast mouse moves


class _Shape:
    def __init__(self, item: Any, color: str, pen: QPen) -> None:  # pyqtgraph has no types
        self.item = item
        self._color = color
        self._pen = pen

    def set_visible(self, visible: bool) -> None:
        self.item.setVisible(visible)

    def set_color(self, color: str) -> None:
        self._color = color
        self.recolor()

    def recolor(self) -> None:
        self._pen.setColor(theme().color(self._color))
        self.item.setPen(self._pen)


class Curve(_Shape):
    def set_points(self, x: Floats, y: Floats, *, gaps: bool = False) -> None:
        """Set the points. With `gaps`, NaN interrupts the curve."""
        self.item.setData(x, y, connect="finite" if gaps else "all", skipFiniteCheck=not gaps)


class _ThinCurve(pg.PlotCurveItem):  # type: ignore[misc] # pyqtgraph has no types
    def paint(self, painter: QPainter, *rest: Any) -> None:
        for _ in strokes(painter):
            super().paint(painter, *rest)


class Line(_Shape):
    def set_value(self, value: float | None) -> None:
        self.item.setVisible(value is not None)
        if value is not None:
            self.item.setValue(value)


class Band(_Shape):
    def set_range(self, ends: tuple[float, float] | None) -> None:
        self.item.setVisible(ends is not None)
        if ends is not None:
            self.item.setRegion(ends)

    def recolor(self) -> None:
        self.item.setBrush(QBrush(theme().color(self._color)))


ShapeT = TypeVar("ShapeT", bound=_Shape)


class _MouseBox(pg.ViewBox):  # type: ignore[misc] # pyqtgraph has no types
    canvas: "PlotCanvas"

    def hoverEvent(self, event: Any) -> None:
        if event.isExit():
            self.canvas.unhovered.emit()
        else:
            self.canvas.hovered.emit(event.scenePos().x())

    def mouseClickEvent(self, event: Any) -> None:
        if event.button() == Qt.MouseButton.LeftButton and not event.double():
            self.canvas.clicked.emit(event.scenePos().x())

    def mouseDragEvent(self, event: Any, axis: int | None = None) -> None:  # noqa: ARG002 - base
        if not self.canvas.is_navigable:
            return
        event.accept()
        with_shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        position, button = event.scenePos(), event.button()
        if button != Qt.MouseButton.LeftButton or with_shift:
            if not event.isFinish():
                self.canvas.panned.emit(position.x() - event.lastScenePos().x())
            return
        pressed = event.buttonDownScenePos()
        if event.isFinish():
            self.rbScaleBox.hide()
            self.canvas.selected.emit(pressed.x(), position.x())
        else:
            left, right = self.mapFromScene(pressed).x(), self.mapFromScene(position).x()
            self.updateScaleBox(QPointF(left, 0), QPointF(right, self.height()))

    def wheelEvent(self, event: Any, axis: int | None = None) -> None:  # noqa: ARG002 - base
        if not self.canvas.is_navigable:
            event.ignore()  # the page scrolls
            return
        event.accept()
        if event.orientation() == Qt.Orientation.Horizontal:
            self.canvas.panned.emit(event.delta() / 2)
        else:
            self.canvas.zoomed.emit(_ZOOM ** (event.delta() / 120), event.scenePos().x())


class PlotCanvas(QWidget):
    """Plot whose axes the caller sets. Pixel coordinates are relative to `viewport`."""

    arranged = Signal()  # the size of the plot or the range of an axis has changed
    hovered = Signal(float)  # x pixel of the mouse
    unhovered = Signal()
    clicked = Signal(float)  # x pixel of a left click
    selected = Signal(float, float)  # x pixels where a drag starts and ends
    zoomed = Signal(float, float)  # factor for the span, and x pixel that must not move
    panned = Signal(float)  # pixels to the right

    def __init__(
        self, name: str, parent: QWidget | None = None, *, is_navigable: bool = False
    ) -> None:
        """`name`: for screen readers. `is_navigable`: handle drags and the mouse wheel."""
        super().__init__(parent)
        self.is_navigable = is_navigable
        self._box = _MouseBox(enableMouse=False, enableMenu=False, defaultPadding=0)
        self._box.canvas = self
        self._box.disableAutoRange()
        self._plot = pg.PlotWidget(self, background=None, viewBox=self._box)
        for part in (self, self._plot.plotItem):
            never_mirror(part)
        self.viewport: QWidget = self._plot.viewport()
        for part in (self._plot, self.viewport):
            part.setAccessibleName(name)
        self._plot.setMenuEnabled(False)
        self._plot.hideButtons()
        self._plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._plot.setFrameShape(self._plot.Shape.NoFrame)
        # A cached background could have the colour of the previous scheme.
        self._plot.setCacheMode(self._plot.CacheModeFlag.CacheNone)
        self._plot.setMinimumSize(120, 40)
        self._axes = {side: self._plot.getAxis(side) for side in ("left", "bottom", "right")}
        # Drawing the grid as one path takes 1 % of the time of pyqtgraph's grid.
        self._grid = QGraphicsPathItem()
        self._grid.setZValue(-10)
        self.add_item(self._grid)
        self._shapes: list[_Shape] = []
        self._x_range = 0.0, 1.0
        self._has_right_axis = False
        column(self._plot, into=self, margins=0)

        theme().changed.connect(self._on_theme_changed)
        self._box.sigResized.connect(self.arranged)
        self._on_theme_changed()
        self._show_fonts()

    @property
    def frame(self) -> QRectF:
        return QRectF(self._box.sceneBoundingRect())

    def add_curve(
        self, color: str, width: float = 1, style: Qt.PenStyle = Qt.PenStyle.SolidLine
    ) -> Curve:
        """Add a line through points. A width of 1 is fastest, but not antialiased."""
        kind = pg.PlotCurveItem if width > 1 else _ThinCurve
        item = kind(antialias=width > 1, skipFiniteCheck=True)
        item.setSegmentedLineMode("off")  # segments would interrupt the dashes
        ratio = self.devicePixelRatioF()
        pen = _pen(width * ratio if width > 1 else 1, style)
        if width <= 1 and style is not Qt.PenStyle.SolidLine:
            pen.setDashPattern([part * ratio for part in pen.dashPattern()])
        return self._add(Curve(item, color, pen))

    def add_line(
        self, color: str, style: Qt.PenStyle = Qt.PenStyle.SolidLine, *, vertical: bool = False
    ) -> Line:
        """Add a straight line. It is hidden until `set_value` is called."""
        item = pg.InfiniteLine(angle=90 if vertical else 0)
        item.setAcceptedMouseButtons(Qt.MouseButton.NoButton)
        item.hide()
        return self._add(Line(item, color, _pen(self.devicePixelRatioF(), style)))

    def add_band(self, color: str) -> Band:
        """Add a filled range behind all other items. It is hidden until `set_range` is called."""
        item = pg.LinearRegionItem(movable=False, pen=QPen(Qt.PenStyle.NoPen))
        item.setZValue(-20)
        item.hide()
        return self._add(Band(item, color, QPen()))

    def add_item(self, item: QGraphicsItem) -> None:
        self._box.addItem(item, ignoreBounds=True)

    def add_overlay(self, item: QGraphicsItem) -> None:
        self._plot.scene().addItem(item)

    def _add(self, shape: ShapeT) -> ShapeT:
        self._box.addItem(shape.item, ignoreBounds=True)
        shape.recolor()
        self._shapes.append(shape)
        return shape

    def set_axes(
        self, x: tuple[float, float], y: tuple[float, float], x_labels: Labels, y_labels: Labels
    ) -> None:
        self._x_range = x
        self._box.setRange(xRange=x, yRange=y, padding=0)
        self._axes["bottom"].setTicks([x_labels])
        self._axes["left"].setTicks([y_labels])
        path = QPainterPath()
        for value, _ in x_labels:
            path.moveTo(value, y[0])
            path.lineTo(value, y[1])
        for value, _ in y_labels:
            path.moveTo(x[0], value)
            path.lineTo(x[1], value)
        self._grid.setPath(path)
        self.arranged.emit()

    def set_right_axis(self, labels: Labels) -> None:
        """Set the labels of the right axis. Without labels, hide the right axis.

        The value of a label is its position on the left axis.
        """
        axis = self._axes["right"]
        if bool(labels) != self._has_right_axis:
            self._has_right_axis = bool(labels)
            self._plot.showAxis("right", self._has_right_axis)
            self._show_fonts()
            self._on_theme_changed()
        if labels:
            metrics = QFontMetrics(self.small_font())
            axis.setWidth(max(metrics.horizontalAdvance(text) for _, text in labels) + 10)
            axis.setTicks([labels])

    @property
    def right_edge(self) -> float:
        """Right edge of the plot, including its right axis, in pixels."""
        width = float(self._axes["right"].width()) if self._has_right_axis else 0.0
        return self.frame.right() + width

    def set_margins(self, *, left: str, top: int, right: int, x_axis: bool) -> None:
        """Set the margins. `left`: widest label. `top`, `right`: pixels."""
        metrics = QFontMetrics(self.small_font())
        self._axes["left"].setWidth(metrics.horizontalAdvance(left) + 10)
        bottom = self._axes["bottom"]
        bottom.setHeight(metrics.height() + 8 if x_axis else 0)
        bottom.setVisible(x_axis)
        below = 1 if x_axis else metrics.height() // 2
        self._plot.getPlotItem().layout.setContentsMargins(1, top, right, below)

    def x_of(self, x: float) -> float:
        return float(self._box.mapViewToScene(QPointF(x, 0)).x())

    def y_of(self, y: float) -> float:
        return float(self._box.mapViewToScene(QPointF(0, y)).y())

    def x_at(self, pixel: float) -> float:
        frame, (low, high) = self.frame, self._x_range
        return low + (pixel - frame.left()) / max(frame.width(), 1.0) * (high - low)

    def labels_in_height(self) -> int:
        return int(self.frame.height() / (1.4 * QFontMetrics(self.small_font()).height()))

    def small_font(self) -> QFont:
        return scaled_font(self.font(), 0.9)

    def _show_fonts(self) -> None:
        for axis in self._axes.values():
            axis.setStyle(tickFont=self.small_font(), tickLength=0, tickTextOffset=6)
            axis.setStyle(hideOverlappingLabels=_LABEL_MARGIN)

    @Slot()
    def _on_theme_changed(self) -> None:
        color = theme().color
        self._plot.setBackground(None)
        self._box.setBackgroundColor(color("plot_background"))
        self._box.setBorder(QPen(color("plot_frame"), 1))
        selection = color("highlight")
        self._box.rbScaleBox.setPen(QPen(selection, 0))
        selection.setAlphaF(0.2)
        self._box.rbScaleBox.setBrush(selection)
        grid = QPen(color("grid"), 1)
        grid.setCosmetic(True)
        self._grid.setPen(grid)
        for axis in self._axes.values():
            axis.setPen(QPen(Qt.PenStyle.NoPen))  # the view box has a border
            axis.setTickPen(QPen(color("plot_frame"), 1))
            axis.setTextPen(QPen(color("plot_text"), 1))
        for shape in self._shapes:
            shape.recolor()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and hasattr(self, "_grid"):
            self._show_fonts()


def _pen(pixels: float, style: Qt.PenStyle) -> QPen:
    # The width of a cosmetic pen is in screen pixels at any scale.
    pen = QPen(Qt.GlobalColor.black, pixels, style)
    pen.setCosmetic(True)
    return pen
