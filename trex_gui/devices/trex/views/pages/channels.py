"""Page of the five live inputs: the raw input, and what the board makes of it."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.descriptions import CHANNEL_ROLES
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.bars import ChannelBar, OutputBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible


class ChannelsPage(QWidget):
    """One row a channel: name, input in µs or V and counts, bar with calibration, output."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("channelsPage")
        self._device = device
        self._source = InputSource.RC

        self._rows: dict[int, tuple[QLabel, ChannelBar, OutputBar]] = {}
        self._summary = ui.label(self, "channelsSummary", wrap=True)
        legend = ui.label(
            self,
            "",
            self.tr(
                "The bar shows the raw input. Its marks are the channel's calibration: full "
                "output at min and max, none within the shaded deadband around neutral. Channels "
                "1 to 3 drive motors in RC and analog mode; in serial mode they are only measured."
            ),
            wrap=True,
        )

        self._grid = ui.grid(spacing=(16, 10), stretch=[(2, 3), (3, 2)])
        headings = (
            self.tr("Channel"),
            self.tr("Input (counts)"),
            self.tr("Raw, with its calibration"),
            self.tr("Remapped (−127 to 127)"),
        )
        for column, text in enumerate(headings):
            self._grid.addWidget(ui.label(self, "", text, bold=True), 0, column)
        for channel in CHANNELS:
            self._add_row(channel)
        ui.column(self._summary, self._grid, legend, 1, into=self)

        device.link_changed.connect(self._on_device_changed)
        device.state_changed.connect(self._on_device_changed)
        device.calibrations.changed.connect(self._on_device_changed)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        self._on_device_changed()

    def _add_row(self, channel: int) -> None:
        role = CHANNEL_ROLES[channel]
        name = ui.label(self, "", f"<b>{channel}</b><br><small>{role}</small>")
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
        for column, widget in enumerate((name, value, bar, output)):
            self._grid.addWidget(widget, channel, column)
        self._rows[channel] = value, bar, output

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        is_connected = state is not None and self._device.is_connected
        if state is None:
            self._summary.setText(self.tr("Connect to a board to see its inputs."))
        else:
            self._source = state.source
            if state.source is InputSource.RC:
                text = self.tr("The inputs are read as RC pulses (µs; 0.4 µs a count).")
            else:
                text = self.tr("The inputs are read as voltages (V; 4.89 mV a count).")
            self._summary.setText(text)
        for channel, (label, bar, output) in self._rows.items():
            label.setEnabled(is_connected)
            bar.set_connected(is_connected)
            output.set_connected(is_connected)
            if state is not None:
                bar.set_source(state.source)
                bar.set_calibration(self._device.calibrations.stored(channel))
        self._renew()

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        telemetry = self._device.telemetry
        if telemetry.raw is None:
            return
        for channel, (_, bar, output) in self._rows.items():
            raw = telemetry.raw_of(channel)
            bar.set_raw(raw)
            # Without a signal the board reports 0, which is no measurement.
            output.set_value(None if raw is None else telemetry.remapped_of(channel))

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        telemetry = self._device.telemetry
        for channel, (label, _, _) in self._rows.items():
            raw = telemetry.raw_of(channel)
            if telemetry.raw is None:
                label.setText(self.tr("N/A"))
            elif raw is None:
                label.setText(self.tr("no signal"))
            else:
                label.setText(f"{self._source.text(raw)} ({raw})")

    def _renew(self) -> None:
        self._on_frame_due()
        self._on_text_due()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._renew()
