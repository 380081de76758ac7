"""Five live inputs: what comes in, and what the board makes of it."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.output_bar import OutputBar
from trex_gui.devices.trex.views.pages.channels.channel_bar import ChannelBar
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible

_CHANNEL, _INPUT, _BAR, _OUTPUT = range(4)


class ChannelsPage(QWidget):
    """One row a channel: name, input in µs or V and counts, bar with calibration, output."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("channelsPage")
        self._device = device
        self._source = InputSource.RC

        self._inputs: dict[int, QLabel] = {}
        self._bars: dict[int, ChannelBar] = {}
        self._outputs: dict[int, OutputBar] = {}
        self._summary = ui.label(self, "channelsSummary", wrap=True)
        self._legend = ui.label(
            self,
            "",
            self.tr(
                "The bar shows the input as it comes in. Its marks are the channel's calibration: "
                "full output at min and max, none within the shaded deadband around neutral. "
                "Channels 1 to 3 drive motors in RC and analog mode; in serial mode they are only "
                "measured."
            ),
            wrap=True,
        )

        grid = ui.grid(spacing=(16, 10), stretch=[(_BAR, 3), (_OUTPUT, 2)])
        for column, text in (
            (_CHANNEL, self.tr("Channel")),
            (_INPUT, self.tr("Input (counts)")),
            (_BAR, self.tr("Raw, with its calibration")),
            (_OUTPUT, self.tr("Remapped (−127 to 127)")),
        ):
            grid.addWidget(self._heading(text), 0, column)
        for channel in CHANNELS:
            self._add_row(grid, channel)
        ui.column(self._summary, grid, self._legend, 1, into=self)

        device.link_changed.connect(self._on_device_changed)
        device.state_changed.connect(self._on_device_changed)
        device.calibrations.changed.connect(self._on_device_changed)
        device.telemetry.updated.connect(self._on_telemetry_updated)
        self._on_device_changed()

    def _heading(self, text: str) -> QLabel:
        return ui.label(self, "", text, bold=True)

    def _add_row(self, grid: QGridLayout, channel: int) -> None:
        row = channel
        role = CHANNEL_ROLES[channel]
        name = QLabel(f"<b>{channel}</b><br><small>{role}</small>", self)
        name.setTextFormat(Qt.TextFormat.RichText)
        value = ui.label(self, f"channel{channel}Input")
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        value.setMinimumWidth(value.fontMetrics().horizontalAdvance("1500 µs (3750)") + 8)
        bar = ui.named(
            ChannelBar(self),
            f"channel{channel}Bar",
            accessible=self.tr("Raw input of channel {0}").format(channel),
        )
        bar.set_value_shown(False)
        output = ui.named(
            OutputBar(self),
            f"channel{channel}Output",
            accessible=self.tr("Remapped channel {0}").format(channel),
        )
        for column, widget in ((_CHANNEL, name), (_INPUT, value), (_BAR, bar), (_OUTPUT, output)):
            grid.addWidget(widget, row, column)
        self._inputs[channel] = value
        self._bars[channel] = bar
        self._outputs[channel] = output

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        there = state is not None and self._device.link is ConnectionState.CONNECTED
        if state is None:
            self._summary.setText(self.tr("Connect to a board to see its inputs."))
        else:
            self._source = state.source
            kind = (
                self.tr("RC pulses (µs; 0.4 µs a count)")
                if state.source is InputSource.RC
                else self.tr("voltages (V; 4.89 mV a count)")
            )
            self._summary.setText(self.tr("The inputs are read as {0}.").format(kind))
        for channel in CHANNELS:
            bar, output = self._bars[channel], self._outputs[channel]
            bar.set_connected(there)
            output.set_connected(there)
            self._inputs[channel].setEnabled(there)
            if state is not None:
                bar.set_source(state.source)
                bar.set_calibration(self._device.calibrations.stored(channel))
        self._on_telemetry_updated()

    @Slot()
    @only_when_visible
    def _on_telemetry_updated(self) -> None:
        telemetry = self._device.telemetry
        for channel in CHANNELS:
            label = self._inputs[channel]
            if telemetry.raw is None:
                label.setText(self.tr("N/A"))
                continue
            raw = telemetry.raw_of(channel)
            self._bars[channel].set_raw(raw)
            if raw is None:
                label.setText(self.tr("no signal"))
            else:
                label.setText(f"{self._source.text(raw)} ({raw})")
            # Without a signal the board reports 0, which is no measurement.
            self._outputs[channel].set_value(
                None if raw is None else telemetry.remapped_of(channel)
            )

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_telemetry_updated()
