"""Find a board: looking on every port for one whose line settings nobody knows."""

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QFrame,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import ScanFinding
from trex_gui.ui.theme.icons import set_icon

_PORT = Qt.ItemDataRole.UserRole


class FindDialog(QDialog):
    """Beside the window, never in its way; closing it ends the search."""

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("findDialog")
        self.setWindowTitle(self.tr("Find a board"))
        self.resize(620, 480)
        self._ports = ports
        self._manager = device_manager
        self._scanner = device_manager.scanner
        self._ticks: dict[Port, bool] = {}
        self._shown: tuple[ScanFinding, ...] | None = None
        self._connects: dict[QPushButton, Port] = {}

        intro = _text(
            self.tr(
                "Asks on each port which device is there: for each kind at its likely settings, "
                "then at every baud rate, with every parity and with CRC. This never moves a "
                "motor and changes no setting. A TReX that hears the questions of another rate "
                "notes UART errors, and stops its motors where it is set to do so."
            ),
            self,
        )
        self._list = QListWidget(self)
        self._list.setObjectName("findPorts")
        self._list.setAccessibleName(self.tr("Ports to look on"))
        self._list.setSelectionMode(QListWidget.SelectionMode.NoSelection)
        self._list.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        label = QLabel(self.tr("&Look on:"), self)
        label.setBuddy(self._list)
        self._busy = _text("", self)
        self._busy.setObjectName("findBusyLabel")
        self._disconnect = QPushButton(self.tr("&Disconnect"), self)
        self._disconnect.setObjectName("findDisconnectButton")
        set_icon(self._disconnect, "disconnect")
        self._full = QCheckBox(
            self.tr(
                "&Full search: also every CRC polynomial and every device number (some minutes)"
            ),
            self,
        )
        self._full.setObjectName("findFullBox")
        self._start = QPushButton(self.tr("&Start"), self)
        self._start.setObjectName("findStartButton")
        self._start.setDefault(True)
        set_icon(self._start, "find")
        self._cancel = QPushButton(self.tr("C&ancel"), self)
        self._cancel.setObjectName("findCancelButton")
        self._cancel.setAutoDefault(False)
        self._progress = QProgressBar(self)
        self._progress.setObjectName("findProgress")
        self._progress.setAccessibleName(self.tr("Progress of the search"))
        self._progress.setTextVisible(False)
        self._tried = _text("", self)
        self._tried.setObjectName("findProgressText")
        self._results = QWidget(self)
        self._results.setObjectName("findResults")
        self._results.setAccessibleName(self.tr("What was found"))
        self._rows = QVBoxLayout(self._results)
        self._rows.setContentsMargins(0, 0, 0, 0)
        self._rows.addStretch(1)
        scroll = QScrollArea(self)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(self._results)
        close = QPushButton(self.tr("Close"), self)
        close.setObjectName("findCloseButton")
        close.setAutoDefault(False)

        busy = QHBoxLayout()
        busy.addWidget(self._busy, 1)
        busy.addWidget(self._disconnect)
        buttons = QHBoxLayout()
        buttons.addWidget(self._start)
        buttons.addWidget(self._cancel)
        buttons.addWidget(self._progress, 1)
        bottom = QHBoxLayout()
        bottom.addStretch(1)
        bottom.addWidget(close)
        layout = QVBoxLayout(self)
        layout.addWidget(intro)
        layout.addSpacing(4)
        layout.addWidget(label)
        layout.addWidget(self._list)
        layout.addLayout(busy)
        layout.addWidget(self._full)
        layout.addLayout(buttons)
        layout.addWidget(self._tried)
        layout.addWidget(scroll, 1)
        layout.addLayout(bottom)

        self._list.itemChanged.connect(self._on_item_changed)
        self._disconnect.clicked.connect(device_manager.leave)
        self._start.clicked.connect(self._on_start_clicked)
        self._cancel.clicked.connect(self._scanner.cancel)
        close.clicked.connect(self.close)
        ports.changed.connect(self._on_ports_changed)
        device_manager.changed.connect(self._on_ports_changed)
        self._scanner.simulators_changed.connect(self._on_ports_changed)
        self._scanner.changed.connect(self._on_finder_changed)
        self._scanner.progressed.connect(self._on_progressed)
        self._on_ports_changed()
        self._on_finder_changed()

    def look(self) -> None:
        """Show it; the search begins when a person says so."""
        self.show()
        self.activateWindow()
        self._start.setFocus()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # minimized is not closed
            self._scanner.cancel()

    # --- Which ports --------------------------------------------------------------------

    @property
    def _chosen(self) -> list[Port]:
        items = [self._list.item(row) for row in range(self._list.count())]
        return [
            item.data(_PORT)
            for item in items
            if item.checkState() is Qt.CheckState.Checked and item.flags() & _ENABLED
        ]

    @Slot()
    def _on_ports_changed(self) -> None:
        """Offer every port that can be searched; ticks stay."""
        with QSignalBlocker(self._list):
            self._list.clear()
            for port in self._ports.entries:
                if self._scanner.can_search(port):
                    self._list.addItem(self._item(port))
        rows = min(max(self._list.count(), 2), 6)
        height = self._list.sizeHintForRow(0)
        if height <= 0:
            height = self.fontMetrics().height() + 4
        self._list.setFixedHeight(rows * height + 2 * self._list.frameWidth() + 4)
        self._on_actions_changed()

    def _item(self, port: Port) -> QListWidgetItem:
        is_open = port == self._manager.current.port
        text = self.tr("{0} – connected to this window") if is_open else "{0}"
        item = QListWidgetItem(text.format(port.label))
        item.setData(_PORT, port)
        item.setFlags(Qt.ItemFlag.ItemIsUserCheckable if is_open else _ENABLED | _CHECKABLE)
        ticked = self._ticks.get(port, port.kind is not PortKind.TYPED or "://" not in port.url)
        is_ticked = ticked and not is_open
        item.setCheckState(Qt.CheckState.Checked if is_ticked else Qt.CheckState.Unchecked)
        return item

    @Slot(QListWidgetItem)
    def _on_item_changed(self, item: QListWidgetItem) -> None:
        self._ticks[item.data(_PORT)] = item.checkState() is Qt.CheckState.Checked
        self._on_actions_changed()

    @Slot()
    def _on_actions_changed(self) -> None:
        running, port = self._scanner.running, self._manager.current.port
        if port is not None:
            self._busy.setText(
                self.tr("{0} is connected to this window, so it is not searched.").format(
                    port.url or port.label
                )
            )
        elif self._list.count() == 0:
            self._busy.setText(self.tr("This computer has no serial ports. Plug an adapter in."))
        self._busy.setVisible(port is not None or self._list.count() == 0)
        self._disconnect.setVisible(port is not None)
        self._list.setEnabled(not running)
        self._full.setEnabled(not running)
        self._start.setEnabled(not running and bool(self._chosen))
        self._cancel.setEnabled(running)
        for connect, its_port in self._connects.items():
            connect.setEnabled(its_port != port)

    # --- The search ---------------------------------------------------------------------

    @Slot()
    def _on_start_clicked(self) -> None:
        self._scanner.start(self._chosen, full=self._full.isChecked())

    @Slot()
    def _on_progressed(self) -> None:
        self._progress.setRange(0, self._scanner.total)
        self._progress.setValue(self._scanner.done)
        self._tried.setText(
            self._scanner.text
            or self._scanner.summary
            or self.tr(
                "The likely settings come first; a port where nobody answers takes about half a "
                "minute."
            )
        )

    @Slot()
    def _on_finder_changed(self) -> None:
        self._on_actions_changed()
        self._on_progressed()
        if self._scanner.findings != self._shown:
            self._shown = self._scanner.findings
            self._show_findings(self._shown)

    def _show_findings(self, findings: tuple[ScanFinding, ...]) -> None:
        self._connects.clear()
        while self._rows.count() > 1:
            if (item := self._rows.takeAt(0)) and (row := item.widget()):
                row.hide()
                row.deleteLater()
        for index, finding in enumerate(findings):
            self._rows.insertWidget(index, self._row(index, finding))

    def _row(self, index: int, finding: ScanFinding) -> QFrame:
        row = QFrame(self._results)
        row.setFrameShape(QFrame.Shape.StyledPanel)
        row.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        layout = QHBoxLayout(row)
        text = _text(finding.text, row)
        text.setObjectName(f"findText{index}")
        text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout.addWidget(text, 1)
        if finding.found is not None:
            connect = QPushButton(self.tr("Connect"), row)
            connect.setObjectName(f"connectFound{index}")
            connect.setAccessibleName(self.tr("Connect to {0}").format(finding.text))
            connect.setAutoDefault(False)
            set_icon(connect, "connect")
            connect.clicked.connect(lambda: self._connect(finding))
            connect.setEnabled(finding.port != self._manager.current.port)
            self._connects[connect] = finding.port
            layout.addWidget(connect, 0, Qt.AlignmentFlag.AlignVCenter)
        return row

    def _connect(self, finding: ScanFinding) -> None:
        """Connect to what was found; the port leads there from now on."""
        if finding.found is None:
            return
        port = self._ports.lead_to(finding.port, finding.device)
        self._manager.connect_with(port, finding.found.settings)


_ENABLED = Qt.ItemFlag.ItemIsEnabled
_CHECKABLE = Qt.ItemFlag.ItemIsUserCheckable


def _text(text: str, parent: QWidget) -> QLabel:
    """Make a label of plain, wrapped text."""
    label = QLabel(text, parent)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    label.setWordWrap(True)  # last: it makes the height follow from the width
    return label
