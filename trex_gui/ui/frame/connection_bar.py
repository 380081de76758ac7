"""Bar above the pages, with connection state, port, line settings, search and help."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QInputDialog,
    QSizePolicy,
    QStyle,
    QStyleOptionComboBox,
    QWidget,
)

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, Ports
from trex_gui.ui.notifier import Answer, ConnectWith, Remedy
from trex_gui.ui.theme.theme import follow_theme, set_look, set_text_color
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ConfirmButton
from trex_gui.ui.widgets.labels import ElidedLabel
from trex_gui.ui.widgets.leds import Lamp
from trex_gui.ui.widgets.messages import InlinePrompt

if TYPE_CHECKING:
    from trex_gui.ui.frame.find_dialog import FindDialog

_NOT_CONNECTED, _OTHER = "not connected", "other"

# Widths in average characters
_PORT, _MIN_PORT = 18, 10
_STATE, _MIN_STATE = 26, 6  # if fewer than 26 are free, baud rate and quality are hidden
_QUALITY, _CONNECT, _MAX_BAR = 11, 14, 116


class PortList(ui.ComboBox):
    def initStyleOption(self, option: QStyleOptionComboBox) -> None:
        """Elide a long text. With a style sheet, Qt would cut it off in the middle of a letter."""
        super().initStyleOption(option)
        combo, field = QStyle.ComplexControl.CC_ComboBox, QStyle.SubControl.SC_ComboBoxEditField
        width = self.style().subControlRect(combo, option, field, self).width() - 2
        text, elide = option.currentText, Qt.TextElideMode.ElideRight
        option.currentText = option.fontMetrics.elidedText(text, elide, width)


class ConnectionBar(QFrame):
    """Bar with a list of ports, and a button that connects or disconnects.

    Selecting a port does not connect to it. The list shows the port that was last connected or
    selected. At first, the list shows the preferred port.
    """

    connecting = Signal()  # emitted before each connection attempt
    choice_changed = Signal()  # `would_connect` may have changed
    line_settings_requested = Signal()
    remedy_chosen = Signal(object)  # a `Remedy`

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        board_name: Callable[[], str],
        question: InlinePrompt,
    ) -> None:
        """`board_name` returns the name of the connected board, or an empty text."""
        super().__init__()
        self.setObjectName("connectionBar")
        self._board_name = board_name
        self._question = question
        self._manager = device_manager
        self._ports = ports
        self._dialog: FindDialog | None = None
        self._connected: Port | None = None
        self._selected: Port | None = None
        self._last: Port | None = None  # port of the last connection attempt
        self._none_selected = False
        self._interim_focus: QWidget | None = None  # focused widget while the button is disabled
        self._create_widgets()

        self._combo.activated.connect(self._on_activated)
        ports.changed.connect(self._on_ports_changed)
        device_manager.changed.connect(self._on_link_changed)
        device_manager.current_changed.connect(self._on_link_changed)
        device_manager.progressed.connect(self._on_progressed)
        self._on_ports_changed()
        self._on_link_changed()

    def _create_widgets(self) -> None:
        self._combo = ui.named(PortList(self), "portCombo", accessible=title_of(tr("&Port:")))
        self._combo.setMinimumContentsLength(_PORT)
        self._combo.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        QShortcut(QKeySequence.mnemonic(tr("&Port:")), self, self._offer_ports)
        # A `ConfirmButton`, so that a double click on Connect does not disconnect.
        self.button = ui.named(ConfirmButton(parent=self), "connectButton")
        self.button.clicked.connect(self.toggle)
        self._line = ui.tool_button(
            self,
            "lineButton",
            " ",  # placeholder for the line settings
            accessible=title_of(tr("&Line settings…")),
            tip=tr("How this computer talks to the board"),
            on_click=self.line_settings_requested,
        )
        self._find = ui.tool_button(
            self,
            "findButton",
            tr("F&ind…"),
            accessible=title_of(tr("&Find a board…")),
            tip=tr("Find a board whose line settings are unknown"),
            on_click=self.find_board,
        )
        self._pill = pill = QFrame(self)
        set_look(pill, "pill")
        self._lamp = Lamp("led_green", pill)
        self._status = ui.named(ElidedLabel("", pill), "statusLabel")
        ui.set_bold(self._status)
        self._status.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._quality = ui.named(ElidedLabel("", pill), "qualityLabel")
        self._remedy = ui.button(
            self,
            "setUpCrcButton",
            tr("Set up CRC…"),
            tip=tr(
                "Let the board detect corrupted bytes; the changes are shown before they "
                "are written"
            ),
            confirms=True,
            on_click=lambda: self.remedy_chosen.emit(Remedy.SET_UP_CRC),
        )
        self._remedy.hide()
        self._progress = ui.progress_bar(self, "progressBar", tr("Progress"))
        self._progress.setFixedWidth(40)
        self._progress.hide()
        # A part that appears takes space from the baud rate and the quality. If that is not
        # enough, it also takes space from the state.
        self._parts = ui.row(
            self._lamp,
            (self._status, 1),
            self._progress,
            self._remedy,
            self._combo,
            self._line,
            self._quality,
            self._find,
            into=pill,
            margins=(10, 1, 6, 1),
        )
        # The window adds the search field and the help button.
        self.row = ui.row((pill, 9), self.button, 0, into=self, margins=(12, 6, 12, 6))
        ui.tab_order(pill, self.button)
        pill.installEventFilter(self)
        follow_theme(self, "space", self._update_space)

    def _update_space(self) -> None:
        character = self.fontMetrics().averageCharWidth()
        self._pill.setMaximumWidth(_MAX_BAR * character)
        self._status.setMinimumWidth(_MIN_STATE * character)
        self._quality.setFixedWidth(_QUALITY * character)
        self._combo.setMinimumWidth(_MIN_PORT * character)
        self.button.setMinimumWidth(_CONNECT * character)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.Resize, QEvent.Type.LayoutRequest}:
            reserved = (_STATE - _MIN_STATE) * self.fontMetrics().averageCharWidth()
            free = self._pill.width() - reserved - self._parts.minimumSize().width()
            widths = {
                part: part.minimumSizeHint().expandedTo(part.minimumSize()).width()
                + self._parts.spacing()
                for part in (self._quality, self._line)
            }
            free += sum(width for part, width in widths.items() if not part.isHidden())
            for part, width in widths.items():
                part.setVisible(width <= free)
                free -= width if width <= free else 0
            self._combo.setMaximumWidth(self._combo.minimumWidth() + max(free, 0))
        return False

    @Slot()
    def toggle(self) -> None:
        if self.would_connect:
            self.connect_shown()
        else:
            self.disconnect_device()

    @property
    def would_connect(self) -> bool:
        """True if idle, or if the list shows a port other than the connected port."""
        shown = self._combo.currentData()
        is_other = isinstance(shown, Port) and shown != self._manager.current.port
        return is_other or self._manager.is_idle

    def disconnect_device(self) -> None:
        """Disconnect. If settings are being written, ask the user first."""
        self._unless_busy(self._manager.disconnect_device)

    def _unless_busy(self, then: Callable[[], object]) -> None:
        if self._manager.current.is_busy:
            self.window().activateWindow()  # shows the question
            self._question.prompt(
                tr(
                    "Settings are still being written. Disconnect anyway? Unwritten settings stay "
                    "pending."
                ),
                Answer("disconnectYes", title_of(tr("&Disconnect")), then),
                is_valid=lambda: self._manager.current.is_busy,
            )
        else:
            then()

    def connect_shown(self) -> None:
        """Connect to the port that the list shows. If the list shows no port, open it."""
        if not self.would_connect:
            return
        shown = self._combo.currentData()
        if isinstance(shown, Port):
            self.connect_to(shown)
        else:
            self._offer_ports()

    def _offer_ports(self) -> None:
        self.window().activateWindow()
        self._combo.setFocus()
        self._combo.showPopup()

    def reconnect(self) -> None:
        if self._last is not None:
            self.connect_to(self._ports.current_entry(self._last) or self._last)

    def connect_with(self, remedy: ConnectWith) -> None:
        """Connect to the shown port with other settings. If there is no port, open the list."""
        port = self._port_to_show() or self._last
        if port is None:
            self._offer_ports()
            return

        def connect() -> None:
            self.connecting.emit()
            self._manager.connect_with(port, remedy.settings)

        self._unless_busy(connect)

    @Slot()
    def find_board(self, *, at_once: bool = False) -> None:
        """Open the search dialog. `at_once`: search the shown port immediately."""
        from trex_gui.ui.frame.find_dialog import FindDialog  # noqa: PLC0415 - not needed at startup

        if self._dialog is None:
            self._dialog = FindDialog(self._manager, self._ports, self._unless_busy, self.window())
            self._dialog.check_requested.connect(
                lambda: self.remedy_chosen.emit(Remedy.CHECK_BOARD)
            )
        self._dialog.open_dialog(self._port_to_show(), at_once=at_once)

    def close_dialogs(self) -> None:
        if self._dialog is not None:
            self._dialog.close()

    @Slot(int)
    def _on_activated(self, index: int) -> None:
        choice = self._combo.itemData(index)
        if isinstance(choice, Port):
            self._select(choice)
        elif choice == _OTHER:
            self._prompt_for_address()
        elif choice == _NOT_CONNECTED:
            self._select(None)

    def _select(self, port: Port | None) -> None:
        self._selected, self._none_selected = port, port is None
        self._on_ports_changed()
        self.choice_changed.emit()

    def _prompt_for_address(self) -> None:
        address, accepted = QInputDialog.getText(
            self,
            title_of(tr("Other port or address…")),
            tr(
                "A device such as /dev/ttyUSB0 or COM3, or a network port such as "
                "socket://host:port or rfc2217://host:port:"
            ),
        )
        if accepted and address.strip():
            self._select(self._ports.add_typed(address))
        else:
            self._on_ports_changed()

    def connect_to(self, port: Port) -> None:
        """Connect to a port. If settings are being written, ask the user first."""

        def connect() -> None:
            self._selected, self._none_selected = port, False
            self.connecting.emit()
            self._manager.connect_to(port)

        self._unless_busy(connect)

    @Slot()
    def _on_ports_changed(self) -> None:
        combo, shown = self._combo, self._port_to_show()
        if shown is not None:
            self._manager.select(shown)
        with QSignalBlocker(combo):
            combo.clear()
            combo.addItem(tr("Not connected"), _NOT_CONNECTED)
            for port in self._ports.entries:
                combo.addItem(port.label, port)
                if port == shown:
                    combo.setCurrentIndex(combo.count() - 1)
            combo.insertSeparator(combo.count())
            combo.addItem(tr("Other port or address…"), _OTHER)
            combo.setToolTip(ui.plain(combo.currentText()))  # the list may elide the text
        self._show_button()

    def _port_to_show(self) -> Port | None:
        selected = self._selected
        if selected is None:
            return None if self._none_selected else self._ports.preferred
        if selected == self._manager.current.port:
            return selected
        return self._ports.current_entry(selected)

    @Slot()
    def _on_link_changed(self) -> None:
        device = self._manager.current
        link, starting, idle = device.link, device.starting, self._manager.is_idle
        opening = link is ConnectionState.CONNECTING or starting
        if device.port != self._connected:
            self._connected = device.port
            if device.port is not None:
                self._selected, self._none_selected = device.port, False
                self._last = device.port
            self._on_ports_changed()
        self._line.setText(device.line_text)
        is_connected = link is ConnectionState.CONNECTED
        self._lamp.set_lit(is_connected)
        status = device.status
        if starting:
            status = tr("Starting the Demo {0} …").format(device.plugin.name)
        self._status.show_text((is_connected and self._board_name()) or status.removesuffix("."))
        self._status.setToolTip(ui.plain(status))
        self._lamp.setAccessibleName(status)
        self._quality.show_text(device.quality.text)
        set_text_color(self._quality, "warning" if device.quality.is_bad else "muted")
        self._remedy.setVisible(device.quality.remedy is not None)
        self._progress.setVisible(opening)
        if opening:
            self._progress.setRange(0, 0)
        self._line.setEnabled(idle and device.has_line_settings)
        self._show_button()

    def _show_button(self) -> None:
        connects = self.would_connect
        text = tr("&Connect") if connects else tr("Dis&connect")
        if text != self.button.text():
            self.button.hold_off()
            self.button.setText(text)
        set_look(self.button, "primary" if connects else "")
        had_focus = self.button.hasFocus()
        self.button.setEnabled(self._manager.current.link is not ConnectionState.DISCONNECTING)
        focused = self.window().focusWidget()
        if had_focus and not self.button.isEnabled():
            self._interim_focus = focused
        elif self.button.isEnabled() and self._interim_focus is not None:
            if focused is self._interim_focus:
                self.button.setFocus()
            self._interim_focus = None

    @Slot(int, int, str)
    def _on_progressed(self, done: int, total: int, step: str) -> None:
        self._progress.setVisible(done < total)
        self._progress.setRange(0, total)
        self._progress.setValue(done)
        self._progress.setToolTip(ui.plain(step))
