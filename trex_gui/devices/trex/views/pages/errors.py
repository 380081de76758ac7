"""Page of every error that the board has reported, and of how good the connection is."""

from datetime import timedelta
from enum import IntEnum
from functools import partial

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QFormLayout,
    QHeaderView,
    QLabel,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.errors import ErrorEntry
from trex_gui.devices.trex.board.quality import quality_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import stops_motors
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import LastColumn, only_when_visible
from trex_gui.ui.widgets.labels import Muted

_Column = IntEnum("_Column", "ERROR ACTIVE STOPS COUNT LAST REMEDY", start=0)


class ErrorsPage(QWidget):
    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("errorsPage")
        self._device = device
        self._items: list[dict[_Column, QTableWidgetItem]] = []
        self._table = self._make_table()
        text = tr(
            "Reading an error clears it in the board; this program counts each one. Errors in bold "
            "were reported since you cleared them."
        )
        tip = tr(
            "Take the errors in bold as known; counts stay, and an error that is still active "
            "comes back at once"
        )
        self._clear = ui.button(self, "clearErrorsButton", tr("C&lear errors"), tip=tip, icon="ok")
        tip = tr("Set every count to zero, and forget when errors were seen")
        title = tr("Reset co&unts")
        self._reset = ui.button(self, "resetCountsButton", title, tip=tip, icon="clear")
        buttons = ui.row((Muted(text, self), 1), self._clear, self._reset, spacing=10)
        self._values: dict[str, QLabel] = {}
        line = self._make_line_box()
        ui.column((self._table, 1), buttons, line, into=self)

        self._clear.clicked.connect(device.board.errors.clear)
        self._reset.clicked.connect(device.board.errors.reset)
        device.errors_changed.connect(self._show_errors)
        for changed in (device.link_changed, device.state_changed):
            changed.connect(self._on_device_changed)
        device.telemetry.text_due.connect(self._on_text_due)
        self._on_device_changed()

    def _make_table(self) -> QTableWidget:
        count = len(self._device.board.errors.entries)
        table = ui.flat_table(QTableWidget(count, len(_Column), self), "errorsTable", tr("Errors"))
        titles = {
            _Column.ERROR: tr("Error"),
            _Column.ACTIVE: tr("Active now"),
            _Column.STOPS: tr("Stopping the motors"),
            _Column.COUNT: tr("Count"),
            _Column.LAST: tr("Last seen"),
            _Column.REMEDY: tr("What it means, and what to do"),
        }
        table.setHorizontalHeaderLabels([titles[column] for column in _Column])
        for row, entry in enumerate(self._device.board.errors.entries):
            items = {column: QTableWidgetItem() for column in _Column}
            self._show_entry(items, entry)  # before the sizes follow every change of a text
            for column, item in items.items():
                table.setItem(row, column, item)
            right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
            items[_Column.COUNT].setTextAlignment(right)
            self._items.append(items)
        table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header = table.horizontalHeader()
        header.sectionResized.connect(table.resizeRowsToContents)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(_Column.REMEDY, QHeaderView.ResizeMode.Fixed)
        LastColumn(table)
        return table

    def _make_line_box(self) -> ui.Card:
        box = ui.Card(tr("Connection"), self)
        restarts_tip = tr(
            "The board came back in another mode, so its power was off meanwhile; it does not "
            "report a restart in the same mode"
        )
        returns_tip = tr(
            "The board was silent for a while: its power was low or off, it restarted, or the "
            "cable has a bad contact"
        )
        requests = tr("Requests:"), tr("Since the connection was opened")
        parts = [
            {"quality": (tr("Quality:"), ""), "requests": requests},
            {"rate": (tr("Reads per second:"), ""), "connected": (tr("Connected for:"), "")},
            {
                "restarts": (tr("Restarts in another mode:"), restarts_tip),
                "returns": (tr("Returned after silence:"), returns_tip),
            },
        ]
        forms = list[QFormLayout]()
        for part in parts:
            form = QFormLayout()
            form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
            value_label = partial(ui.label, box, wrap=not forms, expand=True, selectable=True)
            for key, (title, tip) in part.items():
                value = value_label(f"{key}Value", tip=tip)
                form.addRow(ui.label(box, "", title, tip=tip), value)
                self._values[key] = value
            forms.append(form)
        wide, *narrow = forms
        ui.row((wide, 3), *((form, 1) for form in narrow), into=box, spacing=16)
        return box

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_errors()
        self._on_text_due()

    @Slot()
    def _on_device_changed(self) -> None:
        is_connected = self._device.is_connected
        self._table.setEnabled(is_connected)
        for value in self._values.values():
            value.setEnabled(is_connected)
            if not is_connected:
                value.setText(tr("N/A"))
        self._show_errors()
        self._on_text_due()

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        device = self._device
        self._show_errors()  # an error is over some time after its last report
        opened = device.board.connected_at
        if not device.is_connected or opened is None:
            return
        board, counters, quality = device.board, device.board.counters, device.board.quality
        text = tr("{0}; timeouts: {1}, corrupted replies: {2}, slowest reply: {3:.0f}\u00a0ms")
        slowest = 1000 * counters.slowest
        texts = {
            "quality": quality_text(quality),
            "requests": text.format(
                counters.requests, counters.missing, counters.corrupted, slowest
            ),
            "rate": f"{quality.rate:.0f}" if quality.rate else "–",
            "connected": str(timedelta(seconds=int(now() - opened))),
            "restarts": str(board.restarts),
            "returns": str(board.returns),
        }
        for key, text in texts.items():
            self._values[key].setText(text)

    @Slot()
    @only_when_visible
    def _show_errors(self) -> None:
        errors = self._device.board.errors
        for items, entry in zip(self._items, errors.entries, strict=True):
            self._show_entry(items, entry)
        self._clear.setEnabled(errors.uncleared > 0)
        self._reset.setEnabled(any(one.count or one.is_earlier for one in errors.entries))

    def _show_entry(self, items: dict[_Column, QTableWidgetItem], entry: ErrorEntry) -> None:
        device = self._device
        is_active = device.is_connected and device.board.errors.is_active(entry, now())
        errors_stop = device.parameters.values.stored.get(ParameterKey.UART_ERROR_SHUTDOWN) == 1
        is_stopping = is_active and stops_motors(entry.bit, errors_stop=errors_stop)
        last, doubt = tr("never"), ""
        if entry.is_earlier:
            last = tr("before connecting")
            doubt = tr(
                "Latched before connecting, perhaps by the search for the board; not counted."
            )
        if entry.last is not None:
            last, doubt = entry.last.strftime("%H:%M:%S"), ""
        if entry.is_doubtful:
            last = tr("{0}\n(doubtful)").format(last)
            doubt = tr("The line is noisy and has no CRC: a corrupted reply looks alike.")
        remedy = tr(entry.remedy) if entry.count else ""
        yes, no = tr("⚠ Yes"), tr("No") if device.is_connected else tr("N/A")
        texts = {
            _Column.ERROR: tr(entry.name),
            _Column.ACTIVE: yes if is_active else no,
            _Column.STOPS: yes if is_stopping else no,
            _Column.COUNT: str(entry.count),
            _Column.LAST: last,
            _Column.REMEDY: f"{tr(entry.meaning)} {remedy}".rstrip(),
        }
        for column, text in texts.items():
            item = items[column]
            if item.text() != text:
                item.setText(text)
            font = item.font()
            if column is not _Column.REMEDY and font.bold() != entry.is_uncleared:
                font.setBold(entry.is_uncleared)
                item.setFont(font)
        items[_Column.LAST].setToolTip(doubt)
