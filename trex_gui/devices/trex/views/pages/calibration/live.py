"""The inputs as they are now: in the list of channels, the legend, the curve and its trace."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal, Slot
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.devices.trex.model.calibration.channel_curve import MixWatch
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.pages.calibration.channel_list import ChannelList
from trex_gui.devices.trex.views.pages.calibration.options import ChannelOptions
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.builders import row
from trex_gui.ui.widgets.labels import LegendKey

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.pages.calibration.curve_plot import CurvePlot

_FRAME_MS = 33


class CurveLegend(QWidget):
    """One row: the live dot with its value, the curve, and the stored one while it differs."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("curveLegend")
        self.setAccessibleName(self.tr("Live value"))
        self._live = LegendKey("", "motor2", self, style=None)
        self._curve = LegendKey("", "motor1", self)
        self._stored = LegendKey(self.tr("stored now"), "muted", self, Qt.PenStyle.DashLine)
        # Values that change must not change the least width of the page.
        self._live.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        row((self._live, 1), self._curve, self._stored, into=self, margins=0, spacing=16)

    def set_live(self, text: str) -> None:
        """Show the live value."""
        self._live.setText(text)
        self.setAccessibleDescription(text)

    def set_curves(self, known: bool, *, differs: bool, live: bool) -> None:
        """Name the lines: none, one, or a dashed second one with what is stored."""
        self._live.set_color("motor2" if live else "muted")
        self._curve.setVisible(known)
        self._stored.setVisible(known and live and differs)
        if not live:
            self._curve.setText(self.tr("as last seen"))
        else:
            self._curve.setText(
                self.tr("after Apply") if differs else self.tr("stored in the board")
            )


class LiveInputs(QObject):
    """Shows new samples, at most once a display frame, while the page is visible.

    Signals:
        mixing_changed: `mix.mixed` has changed.

    Attributes:
        mix: what the outputs reveal of the mix jumper.
        plot: where dot and trace are shown.
        timer: runs while the samples are followed.
    """

    mixing_changed = Signal()

    def __init__(
        self,
        device: Device,
        channels: ChannelList,
        legend: CurveLegend,
        options: ChannelOptions,
        page: QWidget,
    ) -> None:
        super().__init__(page)
        self._device = device
        self._channels = channels
        self._legend = legend
        self._options = options
        self._page = page
        self.mix = MixWatch()
        self._mix_shown: bool | None = None
        self.plot: CurvePlot | None = None
        self._in_force = False
        self._frame_of = -1
        self.timer = runtime().timer(self)
        self.timer.setInterval(_FRAME_MS)
        self.timer.timeout.connect(self._on_frame)

    def refresh(self, *, in_force: bool) -> None:
        """Show the newest sample again, for another channel or other settings.

        `in_force`: the calibrations that are shown are those of the measured inputs.
        """
        self._in_force = in_force
        self._frame_of = -1
        self._on_frame()

    @Slot()
    def _on_frame(self) -> None:
        telemetry = self._device.telemetry
        if not self._page.isVisible() or telemetry.samples == self._frame_of:
            return
        self._frame_of = telemetry.samples
        source = self._device.calibrations.source
        for channel in CHANNELS:
            raw = telemetry.raw_of(channel)
            text = self.tr("N/A") if telemetry.raw is None else self.tr("no signal")
            self._channels.set_input(channel, text if raw is None else source.text(raw))
        self._detect_mixing()
        channel = self._channels.channel
        raw = telemetry.raw_of(channel) if self._in_force else None
        self._legend.set_live(self._text(raw))
        if self.plot is not None:
            self.plot.set_raw(raw)
            if self._in_force:
                ring = telemetry.inputs
                self.plot.set_trace(ring.times, ring.values(channel - 1), telemetry.latest)

    def _detect_mixing(self) -> None:
        """Compare the outputs of channels 1 and 2 with those that the board reports."""
        device = self._device
        curves = [
            self._options.curve(channel, device.calibrations.stored(channel), stored=True)
            for channel in (1, 2, 4)
        ]
        raws = [device.telemetry.raw_of(channel) for channel in (1, 2, 4)]
        reported = [device.telemetry.remapped_of(channel) for channel in (1, 2)]
        if device.is_joint:
            self.mix.forget()
        elif curves[2] is not None and not curves[2].is_switched(4, raws[2]):
            known = [curve.output(raw) for curve, raw in zip(curves, raws, strict=True) if curve]
            values = [value for value in reported if value is not None]
            if len(known) == 3 and len(values) == 2:
                self.mix.feed((known[0], known[1]), (values[0], values[1]))
        if self.mix.mixed is not self._mix_shown:
            self._mix_shown = self.mix.mixed
            self.mixing_changed.emit()

    def _text(self, raw: int | None) -> str:
        if not self._in_force:
            return self.tr("no live value: the board reads the other source")
        if self._device.telemetry.raw is None:
            return self.tr("no live value")
        if raw is None:
            return self.tr("no signal now: the output is 0")
        curve = self.plot.curve if self.plot is not None else None
        output = curve.output(raw) if curve is not None else 0
        counts = self.tr("1 count") if raw == 1 else self.tr("{0} counts").format(raw)
        return self.tr("input now {0} ({1}), output {2}").format(
            self._device.calibrations.source.text(raw), counts, f"{output}".replace("-", MINUS)
        )
