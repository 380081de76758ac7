"""Window of a recording of a board."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.client.telemetry import Control, Currents, ModeSample, Raw, Remapped
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.playback import Playback
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.recording import BoardSnapshot
from trex_gui.devices.trex.views.motor_controls import ActionBar
from trex_gui.ui.playback.transport import time_text
from trex_gui.ui.playback.window import RecordingWindow
from trex_gui.ui.plotting.figures import TraceColumn, TraceTable, TraceTableView
from trex_gui.ui.widgets import builders
from trex_gui.ui.widgets.bar import NO_VALUE


class PlaybackWindow(RecordingWindow):
    settings_wanted = Signal(object)  # a `SettingsDocument`, of the position, to be opened

    def __init__(self, playback: Playback, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(playback, "playback", parent=parent)
        self.playback = playback
        text = tr("&Settings at this time…")
        tip = tr("Open the settings that the board stored at this time")
        self._settings = builders.button(
            self, "settingsAtPositionButton", text, icon="settings", tip=tip
        )
        self._settings.clicked.connect(self._on_settings_clicked)
        self._table = TraceTable(self.plot, self)
        table = TraceTableView(self._table, self)
        table.setColumnHidden(TraceColumn.NOW, True)  # there is no newest value
        # The plot needs the room: a long table scrolls.
        table.setMaximumHeight(max(table.minimumHeight(), 8 * self.fontMetrics().height()))

        bar, values = ActionBar(device, "playbackStopButton", self), ValuesPanel(playback, self)
        builders.row(bar.stop, into=bar)
        self.arrange(bar, [self._settings], below_plot=table, above_events=values)

    def device_text(self) -> str:
        return self.playback.header.board

    def show_curves(self) -> None:
        super().show_curves()
        self._table.show_source()

    @Slot()
    def update_figures(self) -> None:
        self._table.refresh()

    @Slot()
    def update_state(self) -> None:
        super().update_state()
        self._settings.setEnabled(self.playback.is_loaded)

    @Slot()
    def _on_settings_clicked(self) -> None:
        seconds = self.playback.position - self.playback.start
        name = tr("{0} at {1}").format(self.playback.path.stem, time_text(seconds))
        self.settings_wanted.emit(SettingsDocument(self.playback.state().settings, name))


class ValuesPanel(QWidget):
    """Shows the values at the position; a dash where nothing was known yet."""

    def __init__(self, playback: Playback, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._playback = playback
        self._cells: dict[str, QLabel] = {}
        self._names: dict[str, str] = {}

        self._control = builders.label(self, "controlAtPosition", wrap=True)
        self._grid = builders.grid(self, margins=0, spacing=(-1, 2), stretch=[(3, 1)])
        self._grid.addWidget(self._control, 0, 0, 1, 4)
        self._grid.setRowMinimumHeight(0, 2 * self.fontMetrics().lineSpacing())
        self._add_headings(1, "", tr("Current"), tr("Setpoint"))
        for motor in (1, 2):
            name = tr("Motor {0}").format(motor)
            self._add_row(1 + motor, name, f"motor{motor}", "current", "setpoint")
        self._add_row(4, tr("Auxiliary"), "auxiliary", "", "setpoint")
        self._grid.setRowMinimumHeight(5, 6)
        self._add_headings(6, "", tr("Signal"), tr("Counts"), tr("Remapped"))
        for channel in CHANNELS:
            name = tr("Channel {0}").format(channel)
            self._add_row(6 + channel, name, f"channel{channel}", "physical", "raw", "remapped")

        for changed in (playback.moved, playback.loaded):
            changed.connect(self.refresh)
        self.refresh()

    def _add_headings(self, row: int, *texts: str) -> None:
        for column, text in enumerate(texts):
            label = builders.label(self, text=text)
            label.setAlignment(Qt.AlignmentFlag.AlignRight)
            self._grid.addWidget(label, row, column)

    def _add_row(self, row: int, title: str, key: str, *parts: str) -> None:
        self._grid.addWidget(builders.label(self, text=title), row, 0)
        width = self.fontMetrics().horizontalAdvance("1500.0 ")
        for column, part in enumerate(parts, 1):
            if not part:
                continue
            name = f"{key}{part.capitalize()}"
            label = builders.label(self, f"{name}AtPosition", NO_VALUE)
            label.setAlignment(Qt.AlignmentFlag.AlignRight)
            label.setMinimumWidth(width)
            self._names[name] = f"{title}, {part}"
            self._cells[name] = label
            self._grid.addWidget(label, row, column)

    @Slot()
    def refresh(self) -> None:
        state = self._playback.state()
        unit, source = self._playback.header.model.current_unit, state[ModeSample].mode.source
        currents, raws, remapped = state.get(Currents), state.get(Raw), state.get(Remapped)
        self._control.setText(self._control_text(state))
        for motor in (1, 2):
            amps = None if currents is None else Number(currents.counts[motor - 1] * unit)
            self._set(f"motor{motor}Current", NO_VALUE if amps is None else f"{amps:.2f} A")
            self._set(f"motor{motor}Setpoint", self._drive_text(state.setpoints.get(motor)))
        auxiliary = state.auxiliary
        self._set("auxiliarySetpoint", NO_VALUE if auxiliary is None else str(auxiliary))
        no_signal = tr("no signal") if raws is not None else NO_VALUE
        for place, channel in enumerate(CHANNELS):
            raw = raws.counts[place] if raws is not None else None
            self._set(f"channel{channel}Raw", no_signal if raw is None else str(raw))
            self._set(f"channel{channel}Physical", NO_VALUE if raw is None else source.text(raw))
            text = NO_VALUE if remapped is None else signed_text(remapped.values[place])
            self._set(f"channel{channel}Remapped", text)

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
        if drive.is_brake:
            return tr("brake {0}").format(drive.speed)
        return signed_text(drive.signed)

    def _set(self, name: str, text: str) -> None:
        label = self._cells[name]
        if label.text() != text:
            label.setText(text)
            label.setAccessibleName(f"{self._names[name]}: {text}")
