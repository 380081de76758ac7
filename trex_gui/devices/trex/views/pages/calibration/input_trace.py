"""The input of the last seconds, along the same axis as the curve above it; now is at the top.

Importing it loads the plotting library: do so when it is to be shown.
"""

import numpy as np
from PySide6.QtCore import QRectF, Qt, Slot
from PySide6.QtGui import QBrush, QPen
from PySide6.QtWidgets import QGraphicsRectItem, QVBoxLayout, QWidget

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.ui.plotting.axes import Labels
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.plotting.data.pyramid import Floats
from trex_gui.ui.theme.theme import theme

SECONDS = 10.0

_LEAST_LINES = 5
"""How many lines of text the plot is high at least: less shows neither noise nor drift."""


class InputTrace(QWidget):
    """Time runs downwards, so the line hangs below the live dot and shows where it has been."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("inputTrace")
        self.setAccessibleName(self.tr("Input of the last 10 seconds"))
        self.setToolTip(self.tr("The input of the last 10 seconds; the newest is at the top"))
        self._canvas = PlotCanvas(self.accessibleName(), self)
        self._deadband = QGraphicsRectItem()
        self._deadband.setZValue(-20)
        self._canvas.add_item(self._deadband)
        self._marks = self._canvas.add_curve("mark", 1)
        self._line = self._canvas.add_curve("motor2", 1)
        self._samples = 0
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._canvas)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    @property
    def frame(self) -> QRectF:
        """The inside of the plot, in pixels of this widget."""
        return self._canvas.frame

    @property
    def samples(self) -> int:
        """How many samples are drawn."""
        return self._samples

    def set_margins(self, *, left: str, right: int) -> None:
        """Leave the same room at the sides as the curve has."""
        line = self._canvas.fontMetrics().height()
        top = line // 2 + 3  # the text at the top is centred on the frame
        self._canvas.set_margins(left=left, top=top, right=right, x_axis=False)
        self._canvas.setMinimumHeight(_LEAST_LINES * line + top + line // 2)

    def set_axis(self, axis: tuple[float, float], x_ticks: Labels) -> None:
        """Show these counts."""
        y_ticks = [(0.0, self.tr("Now")), (SECONDS / 2, "5 s"), (SECONDS, "10 s")]
        self._canvas.set_axes(axis, (SECONDS, 0.0), x_ticks, y_ticks)

    def set_marks(self, calibration: Calibration | None) -> None:
        """Draw minimum, neutral, maximum and the deadband, or none."""
        self._deadband.setVisible(calibration is not None)
        self._marks.set_visible(calibration is not None)
        if calibration is None:
            return
        counts = (calibration.minimum, calibration.neutral, calibration.maximum)
        x = np.repeat(np.array(counts, dtype=float), 3)
        y = np.tile(np.array([0.0, SECONDS, np.nan]), 3)
        self._marks.set_points(x, y, gaps=True)
        left = calibration.neutral - calibration.deadband
        self._deadband.setRect(QRectF(left, 0, 2 * calibration.deadband, SECONDS))

    def set_samples(self, times: Floats, counts: Floats, now: float) -> None:
        """Draw what came in during the last seconds; what is no number is a gap."""
        first = int(np.searchsorted(times, now - SECONDS))
        self._samples = len(times) - first
        self._line.set_points(counts[first:].copy(), now - times[first:], gaps=True)

    def clear(self) -> None:
        """Forget the samples."""
        self._samples = 0
        self._line.set_points(np.empty(0), np.empty(0))

    @Slot()
    def _on_theme_changed(self) -> None:
        self._deadband.setPen(QPen(Qt.PenStyle.NoPen))
        self._deadband.setBrush(QBrush(theme().color("deadband")))
