"""Page of the board, its line, and every reason why its motors do not run."""

from html import escape

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFormLayout, QLabel, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.drive_status import DriveStatus, drive_statuses
from trex_gui.devices.trex.board.quality import quality_text
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Effect
from trex_gui.devices.trex.driving.board_reasons import (
    LED_TEXTS,
    SAFE_START_FLASH,
    SAFE_START_NOTE,
    BoardInputs,
    led_patterns,
)
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import MODE_TEXT
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import Muted, Note, Sign
from trex_gui.ui.widgets.leds import Leds

SIGNS = {
    Effect.STOPS: ("warning", "warning"),
    Effect.BLOCKS: ("info", "info"),
    Effect.LIMITS: ("warning", "warning"),
    Effect.NOTE: ("ok", "good"),
}


class MotorsBox(ui.Card):
    """Every reason why the motors do what they do, and what the LEDs of the board show then."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(tr("Motors"), parent)
        self.setObjectName("statusMotors")
        self._rows: list[tuple[Sign, QLabel]] = []
        self._reasons = ui.grid(spacing=(8, 4), stretch=[(1, 1)])
        self._leds_line = QWidget(self)
        accessible = tr("LEDs that the board shows")
        self._leds = ui.named(Leds(self._leds_line), "statusLeds", accessible=accessible)
        title = ui.label(self._leds_line, "", tr("LEDs on the board:"))
        ui.row(title, (self._leds, 1), into=self._leds_line, margins=0, spacing=10)
        self._steady = ui.named(Muted(tr(SAFE_START_NOTE), self), "statusLedsNote")
        ui.column(self._reasons, self._leds_line, self._steady, into=self)

    def show_statuses(self, statuses: tuple[DriveStatus, ...], board: BoardInputs | None) -> None:
        for row in range(len(self._rows), len(statuses)):
            sign = Sign(self)
            text = ui.label(self, f"motorsReason{row + 1}", wrap=True, rich=True, selectable=True)
            self._reasons.addWidget(sign, row, 0, Qt.AlignmentFlag.AlignTop)
            self._reasons.addWidget(text, row, 1)
            self._rows.append((sign, text))
        for row, (sign, text) in enumerate(self._rows):
            for widget in (sign, text):
                widget.setVisible(row < len(statuses))
            if row < len(statuses):
                status = statuses[row]
                shown = f"<b>{escape(status.text)}</b> {escape(status.remedy)}".rstrip()
                if text.text() != shown:
                    sign.show_sign(*SIGNS[status.blocker.effect])
                    text.setText(shown)
                    text.setAccessibleName(f"{status.text} {status.remedy}".rstrip())
        self._leds_line.setVisible(board is not None)
        patterns = led_patterns(board) if board is not None else ()
        self._steady.setVisible(SAFE_START_FLASH in patterns)
        if patterns:
            red, green = (tr(LED_TEXTS[one], "LED") for one in patterns)
            self._leds.show_patterns(patterns, (red, green), (red, green))


class StatusPage(QWidget):
    setup_requested = Signal()

    def __init__(
        self,
        device: Device,
        start: QWidget,
        parent: QWidget | None = None,
    ) -> None:
        """`start` is shown while nothing is connected."""
        super().__init__(parent)
        self.setObjectName("statusPage")
        self._device = device
        self._start = start
        self._report = QWidget(self)
        self._lost = ui.named(Note(0, self), "statusLost")

        self._values: dict[str, QLabel] = {}
        board = self._form(
            tr("Board"),
            model=tr("Model:"),
            firmware=tr("Firmware:"),
            mode=tr("Mode:"),
            control=tr("In control:"),
            motors=tr("Motors:"),
        )
        line = self._form(
            tr("Line"),
            port=tr("Port:"),
            settings=tr("Settings:"),
            side=tr("Connector:"),
            quality=tr("Quality:"),
        )
        title = tr("Set up my r&obot…")
        self._set_up = ui.button(self._report, "setUpButton", title, icon="settings")
        text = tr("Who drives, jumpers, sticks, motors and limits, step by step.")
        lead = ui.row(self._set_up, (Muted(text, self._report), 1), spacing=10)
        self._motors = MotorsBox(self._report)
        forms = ui.row((board, 3), (line, 2))
        ui.column(lead, self._motors, forms, 1, into=self._report, margins=0)
        ui.column(self._lost, start, (self._report, 1), into=self)

        self._set_up.clicked.connect(self.setup_requested)
        for changed in (device.link_changed, device.state_changed):
            changed.connect(self._on_device_changed)
        device.telemetry.text_due.connect(self._on_text_due)
        for changed in (device.motors.arming_changed, device.motors.lockout_changed):
            changed.connect(self._show_motors)
        self._on_device_changed()

    def _form(self, title: str, **rows: str) -> ui.Card:
        box = ui.Card(title, self)
        form = QFormLayout(box)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for key, text in rows.items():
            value = ui.label(box, f"{key}Value", wrap=True, expand=True, selectable=True)
            form.addRow(text, value)
            self._values[key] = value
        return box

    @Slot()
    def _on_device_changed(self) -> None:
        state, settings = self._device.state, self._device.settings
        is_connected = self._device.is_connected
        is_idle = self._device.link is ConnectionState.DISCONNECTED
        status, *_ = self._show_motors()
        is_lost = status.blocker is DriveBlocker.LOST
        self._lost.show_note(f"{status.text} {status.remedy}" if is_lost else "", alarming=True)
        self._start.setVisible(is_idle)
        self._report.setVisible(not is_idle)
        for label in self._values.values():
            label.setText(tr("N/A"))
            label.setEnabled(is_connected)
        self._set_up.setEnabled(is_connected)
        if state is None or settings is None or not is_connected:
            return
        model, number = state.signature.model, settings.device_number
        addressing = tr("compact packets")
        if number is not None:
            addressing = tr("device number {0}").format(number)
        joint, separate = tr("joint: one motor"), tr("two independent motors")
        rs_232, ttl = tr("RS-232 (everything sent comes back)"), tr("TTL (SI and SO)")
        texts = {
            "model": f"{model.name} ({model.part})",
            "firmware": state.signature.firmware,
            "mode": tr(MODE_TEXT[state.mode]),
            "motors": joint if self._device.board.is_joint else separate,
            "port": settings.label,
            "settings": f"{settings.line.text()}, {addressing}",
            "side": rs_232 if self._device.connection.echo else ttl,
        }
        if self._runs_at_half_rate(state, settings):
            half = tr("This firmware runs at half of this baud rate.")
            texts["firmware"] += f". {half}"
        for key, text in texts.items():
            self._values[key].setText(text)
        self._on_text_due()

    def _runs_at_half_rate(self, state: DeviceState, settings: ConnectionSettings) -> bool:
        wire = state.parameters.get(ParameterKey.UART_SETTINGS)
        if wire is None or wire not in state.specs[ParameterKey.UART_SETTINGS].valid:
            return False
        return settings.line.real_baud(state.signature.firmware) != settings.line.baud

    @Slot()
    def _show_motors(self) -> tuple[DriveStatus, ...]:
        inputs = drive_inputs(self._device)
        statuses = drive_statuses(inputs)
        self._motors.show_statuses(statuses, inputs.board)
        return statuses

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        self._show_motors()
        if not self._device.is_connected:
            return
        self._values["control"].setText(self._device.board.control_text)
        self._values["quality"].setText(quality_text(self._device.board.quality))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_text_due()
