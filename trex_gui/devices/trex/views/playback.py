"""Window that plays back a recording of a board."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QFormLayout, QLabel, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.client.telemetry import Control, Currents, ModeSample, Raw, Remapped
from trex_gui.devices.trex.model.channel_text import input_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.playback import Playback
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.recording import BoardSnapshot
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.ui.playback.window import RecordingWindow
from trex_gui.ui.plotting.figures import TraceColumn, TraceTable, TraceTableView
from trex_gui.ui.widgets import builders
from trex_gui.ui.widgets.bar import NO_VALUE

_WIDEST_VALUE = "0000.0 µs (0000), remapped −000 "


class PlaybackWindow(RecordingWindow):
    def __init__(self, playback: Playback, device: Device) -> None:
        super().__init__(playback, "playback")
        self.playback = playback
        self._table = TraceTable(self.plot, self)
        table = TraceTableView(self._table, self)
        table.setColumnHidden(TraceColumn.NOW, True)
        # A long table scrolls, because the plot needs the space.
        table.setMaximumHeight(max(table.minimumHeight(), 8 * self.fontMetrics().height()))

        bar, values = MotorBar(device, "playbackStopButton", self), ValuesPanel(playback, self)
        bar.fill(bar.armed)
        self.arrange(bar, below_plot=table, above_events=values)

    def device_text(self) -> str:
        return self.playback.header.board

    def show_curves(self) -> None:
        super().show_curves()
        self._table.show_source()

    @Slot()
    def update_figures(self) -> None:
        self._table.refresh()


class ValuesPanel(QWidget):
    """Values at the playback position. A dash replaces an unknown value."""

    def __init__(self, playback: Playback, parent: QWidget) -> None:
        super().__init__(parent)
        self._playback = playback
        self._control = builders.label(self, "controlAtPosition", wrap=True)
        self._control.setMinimumHeight(2 * self.fontMetrics().lineSpacing())
        form = QFormLayout()
        form.setVerticalSpacing(2)
        self._values: dict[str, tuple[str, QLabel]] = {}  # title, value label
        for key, title in (
            ("motor1", tr("Motor {0}").format(1)),
            ("motor2", tr("Motor {0}").format(2)),
            ("auxiliary", tr("Auxiliary")),
            *((f"channel{number}", tr("Channel {0}").format(number)) for number in CHANNELS),
        ):
            value = builders.label(self, f"{key}AtPosition")
            value.setMinimumWidth(self.fontMetrics().horizontalAdvance(_WIDEST_VALUE))
            form.addRow(title, value)
            self._values[key] = title, value
        builders.column(self._control, form, into=self, margins=0)
        for changed in (playback.moved, playback.loaded):
            changed.connect(self.refresh)
        self.refresh()

    @Slot()
    def refresh(self) -> None:
        state = self._playback.state()
        unit, source = self._playback.header.model.current_unit, state[ModeSample].mode.source
        currents, raws, remapped = state.get(Currents), state.get(Raw), state.get(Remapped)
        self._control.setText(self._control_text(state))
        for motor in (1, 2):
            amps = None if currents is None else Number(currents.counts[motor - 1] * unit)
            current = NO_VALUE if amps is None else f"{amps:.2f} A"
            drive = self._drive_text(state.setpoints.get(motor))
            text = tr("{0}, setpoint {1}").format(current, drive)
            self._show(f"motor{motor}", text)
        auxiliary = state.auxiliary
        self._show("auxiliary", NO_VALUE if auxiliary is None else str(auxiliary))
        for index, channel in enumerate(CHANNELS):
            raw = None if raws is None else raws.counts[index]
            text = NO_VALUE if raws is None else tr("no signal")
            if raw is not None:
                text = input_text(source, raw)
            output = NO_VALUE if remapped is None else signed_text(remapped.values[index])
            text = tr("{0}, remapped {1}").format(text, output)
            self._show(f"channel{channel}", text)

    def _show(self, key: str, text: str) -> None:
        title, value = self._values[key]
        value.setText(text)
        value.setAccessibleName(f"{title}: {text}")

    def _control_text(self, state: BoardSnapshot) -> str:
        board_mode, control = state[ModeSample].mode, state.get(Control)
        name = tr("Serial mode with {0} inputs") if board_mode.is_serial else tr("{0} mode")
        text = tr("{0}; the channels control the motors.")
        if control is None:
            text = tr("{0}.")
        elif control.by_serial:
            text = tr("{0}; serial commands reach the motors.")
        return text.format(name.format(board_mode.source.word))

    def _drive_text(self, drive: Drive | None) -> str:
        if drive is None:
            return NO_VALUE
        return tr("brake {0}").format(drive.speed) if drive.is_brake else signed_text(drive.signed)
