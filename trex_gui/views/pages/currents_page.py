"""Both motors' currents against time."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer, Slot
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from trex_gui.model.device import Device, Link
from trex_gui.views.icons import set_icon
from trex_gui.views.widgets.plot_legend import CurveStyle

if TYPE_CHECKING:
    from trex_gui.views.widgets.live_plot import LivePlot

_FRAME_MS = 33
_WINDOWS = (10, 30, 60, 300)


class CurrentsPage(QWidget):
    """A live plot; the plotting library is imported when the page is first shown."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("currentsPage")
        self._device = device

        self._note = QLabel(self)
        self._note.setObjectName("currentsNote")
        self._note.setWordWrap(True)
        self._window = QComboBox(self)
        self._window.setObjectName("currentsWindow")
        self._window.setAccessibleName(self.tr("Time shown"))
        for seconds in _WINDOWS:
            text = f"{seconds} s" if seconds < 60 else f"{seconds // 60} min"
            self._window.addItem(text, seconds)
        self._window.setCurrentIndex(1)
        self._pause = QPushButton(self.tr("Pa&use"), self)
        self._pause.setObjectName("pauseButton")
        self._pause.setCheckable(True)
        set_icon(self._pause, "pause")
        self._plot: LivePlot | None = None
        self._timer = QTimer(self)
        self._timer.setInterval(_FRAME_MS)

        bar = QHBoxLayout()
        bar.addWidget(self._note, 1)
        bar.addWidget(QLabel(self.tr("Show the last"), self))
        bar.addWidget(self._window)
        bar.addWidget(self._pause)
        self._layout = QVBoxLayout(self)
        self._layout.addLayout(bar)

        self._window.currentIndexChanged.connect(self._on_window_changed)
        self._timer.timeout.connect(self._on_frame)
        device.link_changed.connect(self._on_device_changed)
        device.state_changed.connect(self._on_device_changed)
        self._on_device_changed()

    def _make_plot(self) -> "LivePlot":
        """Load the plotting library when the page is first seen: it takes as long as Qt."""
        from trex_gui.views.widgets.live_plot import LivePlot  # noqa: PLC0415

        curves = [
            CurveStyle("motor1", self.tr("Motor 1"), "motor1", "1"),
            CurveStyle("motor2", self.tr("Motor 2"), "motor2", "2"),
        ]
        plot = LivePlot(curves, "A", window=float(self._window.currentData()), parent=self)
        plot.setObjectName("currentsPlot")
        self._layout.addWidget(plot, 1)
        return plot

    @Slot(int)
    def _on_window_changed(self, index: int) -> None:
        if self._plot is not None:
            self._plot.set_window(float(self._window.itemData(index)))
        self._draw()

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        there = state is not None and self._device.link is Link.UP
        self._pause.setEnabled(there)
        if state is None:
            self._note.setText(self.tr("Connect to a board to see its motor currents."))
        elif self._device.is_joint:
            self._note.setText(self.tr("Joint mode: the board does not sense currents."))
        else:
            step = state.signature.model.current_unit * 1000
            self._note.setText(self.tr("One count of this board is {0:.0f} mA.").format(step))
        self._show_limits()
        self._draw()
        if self._plot is not None and not there:
            self._plot.forget_values()

    def _limit_of(self, motor: int) -> float | None:
        """Current limit of a motor in ampere; `None` when it is off or not known."""
        state = self._device.state
        wire = self._device.parameters.stored_of(f"motor{motor}_current_limit")
        if state is None or not wire:
            return None
        return wire * state.specs[f"motor{motor}_current_limit"].scale

    @Slot()
    def _on_frame(self) -> None:
        if self._device.link is Link.UP and not self._pause.isChecked():
            self._draw()

    def _draw(self) -> None:
        if self._plot is None:
            return
        ring, now = self._device.telemetry.currents, self._device.telemetry.latest
        for motor in (1, 2):
            self._plot.set_samples(f"motor{motor}", ring.times, ring.values(motor - 1), now)

    def _show_limits(self) -> None:
        if self._plot is not None:
            for motor in (1, 2):
                self._plot.set_limit(f"motor{motor}", self._limit_of(motor))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._plot is None:
            self._plot = self._make_plot()
            self._show_limits()
        self._draw()
        self._timer.start()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._timer.stop()
