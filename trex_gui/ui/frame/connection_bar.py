"""The row above the pages: which port, how the line is set, how things stand."""

from collections.abc import Callable

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QInputDialog,
    QLabel,
    QProgressBar,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.frame.find_dialog import FindDialog
from trex_gui.ui.theme.icons import set_icon

_NOT_CONNECTED, _OTHER = "not connected", "other"


class ConnectionBar(QWidget):
    """Choosing a port connects to it, as users of the maker's programs expect.

    What the list shows is connected, or what Connect connects to: at first the port that was used
    last or the only one, then whatever was connected or chosen last, a simulated device too.

    Signals:
        connecting: the user has chosen a port.
        line_settings_requested: the user wants to edit them.
        interruption_wanted: what a person wants would cut off the writing of settings; carries
            what does it all the same.
    """

    connecting = Signal()
    line_settings_requested = Signal()
    interruption_wanted = Signal(object)

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._manager = device_manager
        self._ports = ports

        self._combo = QComboBox(self)
        self._combo.setObjectName("portCombo")
        self._combo.setAccessibleName(self.tr("Port"))
        self._combo.setMinimumContentsLength(20)
        self._combo.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        label = QLabel(self.tr("P&ort:"), self)
        label.setBuddy(self._combo)
        self._connect = QPushButton(self.tr("&Connect"), self)
        self._connect.setObjectName("connectButton")
        self._line = QToolButton(self)
        self._line.setObjectName("lineButton")
        self._line.setAccessibleName(self.tr("Line settings"))
        self._line.setToolTip(self.tr("How this computer talks to the board"))
        self._line.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        set_icon(self._line, "settings")
        self._find = QToolButton(self)
        self._find.setObjectName("findButton")
        self._find.setText(self.tr("Find…"))
        self._find.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._find.setAccessibleName(self.tr("Find a board"))
        self._find.setToolTip(self.tr("Find a board whose line settings are not known"))
        set_icon(self._find, "find")
        self._dialog: FindDialog | None = None
        self._connected: Port | None = None
        self._chosen: Port | None = None
        self._wants_none = False
        self._status = QLabel(self)
        self._status.setObjectName("statusLabel")
        self._status.setWordWrap(True)
        self._status.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._progress = QProgressBar(self)
        self._progress.setObjectName("progressBar")
        self._progress.setAccessibleName(self.tr("Progress"))
        self._progress.setFixedWidth(70)
        self._progress.setTextVisible(False)
        self._progress.hide()

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for widget in (label, self._combo, self._connect, self._line, self._find):
            layout.addWidget(widget)
        layout.addSpacing(8)
        layout.addWidget(self._status, 1)
        layout.addWidget(self._progress)

        self._combo.activated.connect(self._on_activated)
        self._connect.clicked.connect(self.toggle)
        self._line.clicked.connect(self.line_settings_requested)
        self._find.clicked.connect(self.find_board)
        ports.changed.connect(self._on_ports_changed)
        device_manager.changed.connect(self._on_link_changed)
        device_manager.current_changed.connect(self._on_link_changed)
        device_manager.progressed.connect(self._on_progressed)
        self._on_ports_changed()
        self._on_link_changed()

    # --- What a person does -------------------------------------------------------------

    @Slot()
    def toggle(self) -> None:
        """Connect, or disconnect."""
        if self._manager.is_idle:
            self.connect_shown()
        else:
            self.leave()

    def leave(self) -> None:
        """Disconnect, after a question while settings are being written."""
        self._when_nothing_is_cut_off(self._manager.leave)

    def _when_nothing_is_cut_off(self, then: Callable[[], object]) -> None:
        if self._manager.current.is_busy:
            self._on_ports_changed()  # the combo box has the next port already
            self.interruption_wanted.emit(then)
        else:
            then()

    def connect_shown(self) -> None:
        """Connect to the port that the list shows; where it shows none let a person choose."""
        if not self._manager.is_idle:
            return
        shown = self._combo.currentData()
        if isinstance(shown, Port):
            self._connect_to(shown)
        else:
            self._combo.setFocus()
            self._combo.showPopup()

    @Slot()
    def find_board(self) -> None:
        """Show the search for a board whose line settings nobody knows."""
        if self._dialog is None:
            self._dialog = FindDialog(self._manager, self._ports, self.window())
        self._dialog.look()

    def close_dialogs(self) -> None:
        """Close what stands beside the window, for its end."""
        if self._dialog is not None:
            self._dialog.close()

    @Slot(int)
    def _on_activated(self, index: int) -> None:
        choice = self._combo.itemData(index)
        if isinstance(choice, Port):
            if choice != self._manager.current.port:
                self._connect_to(choice)
        elif choice == _OTHER:
            self._ask_for_address()
        elif choice == _NOT_CONNECTED:
            self._when_nothing_is_cut_off(self._leave_for_good)

    def _leave_for_good(self) -> None:
        """Disconnect, and offer no port: somebody has chosen none."""
        self._chosen, self._wants_none = None, True
        self._manager.leave()

    def _ask_for_address(self) -> None:
        address, given = QInputDialog.getText(
            self,
            self.tr("Other port or address"),
            self.tr(
                "A device such as /dev/ttyUSB0 or COM3, or a network port such as "
                "socket://host:port or rfc2217://host:port:"
            ),
        )
        if given and address.strip():
            self._connect_to(self._ports.add_typed(address))
        else:
            self._on_ports_changed()

    def _connect_to(self, port: Port) -> None:
        def connect_to() -> None:
            self._chosen, self._wants_none = port, False
            self.connecting.emit()
            self._manager.connect_to(port)

        self._when_nothing_is_cut_off(connect_to)

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_ports_changed(self) -> None:
        """Show every port; the current one is connected, or what Connect connects to."""
        combo, shown = self._combo, self._port_to_show()
        with QSignalBlocker(combo):
            combo.clear()
            combo.addItem(self.tr("Not connected"), _NOT_CONNECTED)
            for port in self._ports.entries:
                combo.addItem(port.label, port)
            combo.insertSeparator(combo.count())
            combo.addItem(self.tr("Other port or address…"), _OTHER)
            for index in range(combo.count()):
                if shown is not None and combo.itemData(index) == shown:
                    combo.setCurrentIndex(index)
                    break

    def _port_to_show(self) -> Port | None:
        connected, chosen = self._manager.current.port, self._chosen
        if connected is not None:
            return connected
        if chosen is None:
            return None if self._wants_none else self._ports.preferred
        # As it is in the list now: what it leads to, and so its label, may be another.
        is_demo = chosen.kind is PortKind.DEMO
        return self._ports.demo_of(chosen.device) if is_demo else self._ports.find(chosen.url)

    @Slot()
    def _on_link_changed(self) -> None:
        device = self._manager.current
        link, starting, idle = device.link, device.starting, self._manager.is_idle
        opening = link is ConnectionState.CONNECTING or starting
        if device.port != self._connected:
            self._connected = device.port
            if device.port is not None:
                self._chosen, self._wants_none = device.port, False
            self._on_ports_changed()
        self._line.setText(device.line_text)
        self._status.setText(
            self.tr("Starting the simulated {0} …").format(device.plugin.name)
            if starting
            else device.status
        )
        self._progress.setVisible(opening)
        if opening:
            self._progress.setRange(0, 0)
        self._connect.setText(self.tr("&Connect") if idle else self.tr("Dis&connect"))
        set_icon(self._connect, "connect" if idle else "disconnect")
        self._connect.setEnabled(link is not ConnectionState.DISCONNECTING)
        self._line.setEnabled(idle and device.has_line_settings)

    @Slot(int, int, str)
    def _on_progressed(self, done: int, total: int, what: str) -> None:
        self._progress.setVisible(done < total)
        self._progress.setRange(0, total)
        self._progress.setValue(done)
        self._progress.setToolTip(what)
