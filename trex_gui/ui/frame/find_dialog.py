"""Dialog that finds boards with unknown line settings."""

from collections.abc import Callable

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QGuiApplication, QHideEvent
from PySide6.QtWidgets import (
    QFrame,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QSizePolicy,
    QWidget,
)

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import ScanFinding
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox

_PORT = Qt.ItemDataRole.UserRole
_ENABLED = Qt.ItemFlag.ItemIsEnabled
_CHECKABLE = Qt.ItemFlag.ItemIsUserCheckable


class FindDialog(ReusedDialog):
    """Non-modal search dialog. Closing it ends the scan."""

    check_requested = Signal()  # the user needs help with checking a board

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        unless_busy: Callable[[Callable[[], object]], object],
        parent: QWidget | None = None,
    ) -> None:
        """`unless_busy`: calls a function that disconnects, possibly after asking the user."""
        super().__init__(parent)
        self.setObjectName("findDialog")
        self.setWindowTitle(title_of(tr("&Find a board…")))
        resize_with_font(self, 620, 480)
        self._ports = ports
        self._manager = device_manager
        self._unless_busy = unless_busy
        self._scanner = device_manager.scanner
        self._checked: dict[Port, bool] = {}  # check boxes that the user has changed
        self._first: Port | None = None  # port selected in the window, listed first
        self._shown_findings: tuple[ScanFinding, ...] | None = None
        self._connect_buttons: dict[QPushButton, Port] = {}
        self._create_widgets()

        ports.changed.connect(self._on_ports_changed)
        device_manager.changed.connect(self._on_ports_changed)
        self._scanner.simulators_changed.connect(self._on_ports_changed)
        self._scanner.changed.connect(self._on_scanner_changed)
        self._scanner.progressed.connect(self._on_progressed)
        self._scanner.finished.connect(self._on_finished)
        self._on_ports_changed()
        self._on_scanner_changed()

    def _create_widgets(self) -> None:
        self._list = ui.named(QListWidget(self), "findPorts")
        self._list.setSelectionMode(QListWidget.SelectionMode.NoSelection)
        self._list.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._list.itemChanged.connect(self._on_item_changed)
        self._busy = ui.label(self, "findBusyLabel", wrap=True, expand=True)
        self._disconnect = ui.button(
            self,
            "findDisconnectButton",
            tr("&Disconnect"),
            icon="disconnect",
            on_click=lambda: self._unless_busy(self._manager.disconnect_device),
        )
        self._full = ui.check_box(
            self,
            "findFullBox",
            tr(
                "&Full search: also try every CRC polynomial and every device number (takes a "
                "few minutes)"
            ),
        )
        self._start = ui.button(
            self,
            "findStartButton",
            tr("&Start"),
            icon="find",
            default=True,
            on_click=lambda: self._scanner.start(self._selected_ports, full=self._full.isChecked()),
        )
        text, cancel = tr("C&ancel"), self._scanner.cancel
        self._cancel = ui.button(self, "findCancelButton", text, default=False, on_click=cancel)
        self._progress = ui.progress_bar(self, "findProgress", tr("Progress of the search"))
        self._progress_note = ui.named(Note(2, self), "findProgressText")
        self._results = ui.named(QWidget(self), "findResults", accessible=tr("Found devices"))
        self._rows = ui.column(1, into=self._results, margins=0)
        about = tr(
            "Probes each port for every supported device, first at its likely settings, then "
            "at every baud rate, with every parity and with CRC. Probes never move a motor "
            "or change a setting of a TReX or an Aracna. Other devices on the line may "
            "react: enter their numbers in the line settings first. A TReX that receives "
            "probes at another rate counts UART errors, and stops its motors if it is set to "
            "do so."
        )
        self._check = ui.button(
            self,
            "findCheckButton",
            tr("C&heck the board…"),
            default=False,
            tip=tr("What the LEDs mean, how to wire the board, and how to restore serial settings"),
            on_click=self.check_requested,
        )
        close = ui.button(self, "findCloseButton", tr("Close"), default=False, on_click=self.close)
        ui.column(
            ui.label(self, text=self.windowTitle(), size="title"),
            ui.label(self, text=about, wrap=True, expand=True),
            ui.label(self, text=tr("Search &on:"), buddy=self._list),
            self._list,
            ui.row((self._busy, 1), self._disconnect),
            self._full,
            ui.row(self._start, self._cancel, (self._progress, 1)),
            self._progress_note,
            (ScrollBox(self._results, self), 1),
            ui.row(self._check, 1, close),
            into=self,
        )

    def open_dialog(self, selected: Port | None, *, at_once: bool = False) -> None:
        """Open the dialog. `at_once`: search the `selected` port immediately."""
        self._first = selected
        self._on_ports_changed()
        self.show_in_front()
        self._start.setFocus()
        if at_once and selected in self._selected_ports and not self._scanner.running:
            self._scanner.start([selected])

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # minimizing does not close the dialog
            self._scanner.cancel()

    @property
    def _selected_ports(self) -> list[Port]:
        items = [self._list.item(row) for row in range(self._list.count())]
        return [
            item.data(_PORT)
            for item in items
            if item.checkState() is Qt.CheckState.Checked and item.flags() & _ENABLED
        ]

    @Slot()
    def _on_ports_changed(self) -> None:
        with QSignalBlocker(self._list):
            self._list.clear()
            for port in sorted(self._ports.entries, key=lambda port: port != self._first):
                if self._scanner.can_scan(port):
                    self._list.addItem(self._item(port))
        rows = min(max(self._list.count(), 2), 6)
        height = self._list.sizeHintForRow(0)  # negative if the list is empty
        height = height if height > 0 else self.fontMetrics().height() + 4
        self._list.setFixedHeight(rows * height + 2 * self._list.frameWidth() + 4)
        self._on_actions_changed()

    def _item(self, port: Port) -> QListWidgetItem:
        is_open = port == self._manager.current.port
        text = tr("{0} – connected to this window") if is_open else "{0}"
        item = QListWidgetItem(text.format(port.label))
        item.setData(_PORT, port)
        item.setFlags(_CHECKABLE if is_open else _ENABLED | _CHECKABLE)
        is_likely = port.kind is not PortKind.TYPED or "://" not in port.url
        is_checked = self._checked.get(port, is_likely) and not is_open
        item.setCheckState(Qt.CheckState.Checked if is_checked else Qt.CheckState.Unchecked)
        return item

    @Slot(QListWidgetItem)
    def _on_item_changed(self, item: QListWidgetItem) -> None:
        self._checked[item.data(_PORT)] = item.checkState() is Qt.CheckState.Checked
        self._on_actions_changed()

    @Slot()
    def _on_actions_changed(self) -> None:
        running, port = self._scanner.running, self._manager.current.port
        if port is not None:
            text = tr("{0} is connected to this window, so it is not searched.")
            self._busy.setText(text.format(port.url or port.label))
        elif self._list.count() == 0:
            self._busy.setText(tr("This computer has no serial ports. Plug in an adapter."))
        self._busy.setVisible(port is not None or self._list.count() == 0)
        self._disconnect.setVisible(port is not None)
        if running:  # the focus moves from Start to Cancel
            self._cancel.setEnabled(True)
        self._list.setEnabled(not running)
        self._full.setEnabled(not running)
        self._start.setEnabled(not running and bool(self._selected_ports))
        if not running and self.focusWidget() is self._cancel:  # the focus moves to the first board
            next(iter(self._connect_buttons), self._start).setFocus()
        self._cancel.setEnabled(running)
        self._check.setVisible(self._manager.current.has_line_settings)
        for connect, found_at in self._connect_buttons.items():
            connect.setEnabled(found_at != port)

    @Slot()
    def _on_progressed(self) -> None:
        self._progress.setRange(0, self._scanner.total)
        self._progress.setValue(self._scanner.done)
        hint = tr(
            "The likely settings come first; a port without a reply takes about half a minute."
        )
        self._progress_note.setText(self._scanner.text or self._scanner.summary or hint)

    @Slot()
    def _on_scanner_changed(self) -> None:
        self._on_actions_changed()
        self._on_progressed()
        if self._scanner.findings != self._shown_findings:
            self._shown_findings = self._scanner.findings
            self._show_findings(self._shown_findings)

    @Slot()
    def _on_finished(self) -> None:
        """Save the device found at each port. If boards share a line, save none of them."""
        boards = [finding for finding in self._scanner.findings if finding.found is not None]
        ports = [finding.port for finding in boards]
        for board in boards:
            if board.found is not None and ports.count(board.port) == 1:
                self._ports.assign(board.port, board.device, board.found.settings.packed)

    def _show_findings(self, findings: tuple[ScanFinding, ...]) -> None:
        self._connect_buttons.clear()
        while self._rows.count() > 1:
            if (item := self._rows.takeAt(0)) and (row := item.widget()):
                row.hide()
                row.deleteLater()
        ordered = sorted(findings, key=lambda finding: finding.found is None)
        rows = [self._row(index, finding) for index, finding in enumerate(ordered)]
        for index, row in enumerate(rows):
            self._rows.insertWidget(index, row)
        ui.tab_order(self._cancel, *rows)

    def _row(self, index: int, finding: ScanFinding) -> QFrame:
        row = QFrame(self._results)
        set_look(row, "card")
        row.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        name = f"findText{index}"
        text = ui.label(row, name, finding.text, wrap=True, expand=True, selectable=True)
        layout = ui.row((text, 1), into=row)
        if finding.found is not None:
            connect = ui.button(
                row,
                f"connectFound{index}",
                title_of(tr("&Connect")),
                icon="connect",
                accessible=tr("Connect to {0}").format(finding.text),
                default=False,
                on_click=lambda: self._connect(finding),
            )
            connect.setEnabled(finding.port != self._manager.current.port)
            self._connect_buttons[connect] = finding.port
            layout.addWidget(connect, 0, Qt.AlignmentFlag.AlignVCenter)
        if finding.command:
            copy = ui.button(row, f"copyCommand{index}", tr("Copy command"), default=False)
            copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(finding.command))
            layout.addWidget(copy, 0, Qt.AlignmentFlag.AlignVCenter)
        return row

    def _connect(self, finding: ScanFinding) -> None:
        if finding.found is not None:
            port = self._ports.assign(finding.port, finding.device)
            settings = finding.found.settings
            self._unless_busy(lambda: self._manager.connect_with(port, settings))
            self.close()
