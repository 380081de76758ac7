"""Plot of the last ten seconds of currents. Importing this module loads pyqtgraph."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.telemetry import Series
from trex_gui.ui.plotting.axes import ValueAxis
from trex_gui.ui.plotting.canvas import PlotCanvas

_SECONDS, _BINS = 10.0, 200
_STEP = 0.1  # seconds of new samples between redraws
_SERIES = {1: Series.CURRENT1, 2: Series.CURRENT2}


class CurrentStrip(PlotCanvas):
    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(tr("Motor currents"), parent)
        self.setObjectName("currentStrip")
        self.viewport.setAutoFillBackground(False)  # the card has its own background
        self._device = device
        self._axis = ValueAxis("A")
        self._curves = {motor: self.add_curve(f"motor{motor}") for motor in _SERIES}
        dashes = Qt.PenStyle.DashLine
        self._limits = {motor: self.add_line(f"motor{motor}", dashes) for motor in _SERIES}
        self.set_margins(left="0.0 A", top=8, right=1, x_axis=False)
        self.draw()

    def _newest(self) -> float:
        span = self._device.telemetry.currents.span
        return span[1] if span is not None else 0.0

    def draw_if_due(self) -> None:
        if abs(self._newest() - self._end) >= _STEP:
            self.draw()

    def draw(self) -> None:
        history, end = self._device.telemetry.currents, self._newest()
        self._end = end
        highest = 0.0
        for motor, series in _SERIES.items():
            times, amps = history.points(series, end - _SECONDS, end, _BINS)
            is_known = np.isfinite(amps)
            self._curves[motor].set_points(times - end, amps, gaps=not is_known.all())
            self._limits[motor].set_value(self._device.current_limit(motor) or None)
            highest = max(highest, float(amps[is_known].max(initial=0.0)))
        self._axis.fit([(0.0, highest)])
        labels = self._axis.labels(self.labels_in_height())
        self.set_axes((-_SECONDS, 0.0), self._axis.reach, [], labels)
