"""What is connected, how it is set up, and every error it has reported."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFormLayout,
    QGroupBox,
    QHeaderView,
    QLabel,
    QSizePolicy,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from trex_gui.devices.trex.client.explanations import MODE_TEXT
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameters_of
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import name_headers, only_when_visible

_NAME, _COUNT, _LAST, _MEANING = range(4)


class StatusPage(QWidget):
    """Board, line and errors at a glance."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("statusPage")
        self._device = device

        self._values: dict[str, QLabel] = {}
        board = self._form(
            self.tr("Board"),
            {
                "model": self.tr("Model:"),
                "firmware": self.tr("Firmware:"),
                "mode": self.tr("Mode:"),
                "control": self.tr("In control:"),
                "motors": self.tr("Motors:"),
            },
        )
        line = self._form(
            self.tr("Line"),
            {
                "port": self.tr("Port:"),
                "settings": self.tr("Settings:"),
                "side": self.tr("Connector:"),
                "traffic": self.tr("Requests:"),
                "quality": self.tr("Failures:"),
            },
        )
        errors = QGroupBox(self.tr("Errors seen"), self)
        self._table = self._error_table(errors)
        self._reset = ui.button(errors, "resetCountsButton", self.tr("Reset c&ounts"), icon="clear")

        ui.column(self._table, (self._reset, 0, Qt.AlignmentFlag.AlignRight), into=errors)
        top = ui.row((board, 3), (line, 2))
        ui.column(top, (errors, 1), into=self)

        self._reset.clicked.connect(device.errors.reset)
        device.link_changed.connect(self._on_device_changed)
        device.state_changed.connect(self._on_device_changed)
        device.errors.changed.connect(self._on_errors_changed)
        device.telemetry.updated.connect(self._on_telemetry_updated)
        theme().changed.connect(self._on_errors_changed)
        self._on_device_changed()
        self._on_errors_changed()

    def _form(self, title: str, rows: dict[str, str]) -> QGroupBox:
        box = QGroupBox(title, self)
        form = QFormLayout(box)
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for key, text in rows.items():
            value = ui.label(box, f"{key}Value", wrap=True, selectable=True)
            value.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
            form.addRow(text, value)
            if isinstance(label := form.labelForField(value), QLabel):
                label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop)
            self._values[key] = value
        return box

    def _error_table(self, parent: QWidget) -> QTableWidget:
        entries = self._device.errors.entries
        table = ui.named(
            QTableWidget(len(entries), 4, parent), "errorsTable", accessible=self.tr("Errors seen")
        )
        name_headers(table)
        table.setHorizontalHeaderLabels(
            [self.tr("Error"), self.tr("Count"), self.tr("Last seen"), self.tr("What it means")]
        )
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        table.setAlternatingRowColors(True)
        table.setShowGrid(False)
        table.setWordWrap(False)
        table.verticalHeader().hide()
        table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + 8)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(_MEANING, QHeaderView.ResizeMode.Stretch)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        for row, entry in enumerate(entries):
            for column, text in ((_NAME, entry.name), (_COUNT, "0"), (_LAST, "never")):
                table.setItem(row, column, QTableWidgetItem(text))
            meaning = QTableWidgetItem(entry.meaning)
            meaning.setToolTip(entry.meaning)
            table.setItem(row, _MEANING, meaning)
            if item := table.item(row, _COUNT):
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        return table

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        settings = self._device.settings
        not_there = self.tr("N/A")
        up = self._device.link is ConnectionState.CONNECTED
        for label in self._values.values():
            label.setText(not_there)
            label.setEnabled(up)
        self._table.setEnabled(up)
        if state is None or settings is None or not up:
            return
        model = state.signature.model
        joint = self._device.is_joint
        texts = {
            "model": f"{model.name} ({model.part})",
            "firmware": state.signature.firmware,
            "mode": MODE_TEXT[state.mode],
            "motors": self.tr("joint: one motor") if joint else self.tr("two independent motors"),
            "port": settings.name or settings.url,
            "settings": settings.line.text() + self._address_text(settings.device_number),
            "side": self.tr("RS-232 (everything sent comes back)")
            if self._device.connection.echo
            else self.tr("TTL (SI and SO)"),
        }
        if old := self._half_rate_warning():
            texts["firmware"] += f". {old}"
        for key, text in texts.items():
            self._values[key].setText(text)
        self._on_telemetry_updated()

    def _address_text(self, number: int | None) -> str:
        if number is None:
            return self.tr(", compact packets")
        return self.tr(", device number {0}").format(number)

    def _half_rate_warning(self) -> str:
        state, settings = self._device.state, self._device.settings
        if state is None or settings is None:
            return ""
        wire = state.parameters.get(ParameterKey.UART_SETTINGS)
        specs = parameters_of(state.signature.model.key, state.signature.firmware)
        if wire is None or wire not in specs[ParameterKey.UART_SETTINGS].valid:
            return ""
        if settings.line.real_baud(state.signature.firmware) == settings.line.baud:
            return ""
        return self.tr("This firmware runs at half of this baud rate.")

    @Slot()
    @only_when_visible
    def _on_telemetry_updated(self) -> None:
        if self._device.link is not ConnectionState.CONNECTED:
            return
        counters = self._device.connection.counters
        self._values["control"].setText(self._device.control_text)
        failures = counters.silences + counters.damaged
        good = 100 * (1 - failures / max(counters.requests, 1))
        self._values["traffic"].setText(
            self.tr("{0} of {1} answered ({2:.2f} %)").format(
                counters.requests - failures, counters.requests, good
            )
        )
        self._values["quality"].setText(
            self.tr("{0} timeouts, {1} corrupted, slowest reply {2:.0f}\u00a0ms").format(
                counters.silences, counters.damaged, 1000 * counters.slowest
            )
        )

    def showEvent(self, event: object) -> None:
        super().showEvent(event)  # type: ignore[arg-type]  # Qt hands its own event on
        self._on_telemetry_updated()

    @Slot()
    def _on_errors_changed(self) -> None:
        for row, entry in enumerate(self._device.errors.entries):
            last = entry.last.strftime("%H:%M:%S") if entry.last else self.tr("never")
            for column, text in ((_COUNT, str(entry.count)), (_LAST, last)):
                if item := self._table.item(row, column):
                    item.setText(text)
            if name := self._table.item(row, _NAME):
                font = name.font()
                font.setBold(entry.count > 0)
                name.setFont(font)
