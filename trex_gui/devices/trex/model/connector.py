"""From a choice in the port list to an open line."""

from dataclasses import replace

from PySide6.QtCore import QObject, QSettings, Signal, Slot

from trex_gui.core.errors import BadRequest
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.model.demo.board import DemoBoard
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.crc7 import check_polynomial
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator_process import Simulator

_LINE = "line/settings"
_NUMBER = "line/device_number"
_POLYNOMIAL = "line/polynomial"


class Connector(QObject):
    """Connects a device to what a person picked, with the line settings that they chose.

    Signals:
        settings_changed: `settings` are others.
        port_changed: `port` is another.
        demo_changed: `demo_in_use`.
        failed: why nothing was connected, for people.
    """

    settings_changed = Signal()
    port_changed = Signal()
    demo_changed = Signal()
    failed = Signal(str)

    def __init__(
        self,
        device: Device,
        ports: Ports,
        parent: QObject | None = None,
        *,
        timeouts: Timeouts | None = None,
    ) -> None:
        super().__init__(parent)
        self._device = device
        self._ports = ports
        self._store = QSettings(self)
        self._timeouts = timeouts or Timeouts()
        self._settings = self._read_settings()
        self._port: Port | None = None
        self._demo_wanted = False
        self._demo_in_use = False
        self._demo_settings: ConnectionSettings | None = None
        self.simulator = Simulator(self)
        self.demo_board = DemoBoard(self.simulator, self)
        self.finder = DeviceScanner(self.simulator, self, timeouts=self._timeouts)
        self._after_search: Port | None = None

        self.simulator.ready.connect(self._on_simulator_ready)
        self.simulator.failed.connect(self._on_simulator_failed)
        self.simulator.ended.connect(self._on_simulator_ended)
        self.demo_board.made_new.connect(self._on_demo_made_new)
        self.finder.finished.connect(self._on_search_finished)
        device.link_changed.connect(self._on_link_changed)

    @property
    def settings(self) -> ConnectionSettings:
        """Line settings for the next connection; the address comes with the port."""
        return self._settings

    @property
    def port(self) -> Port | None:
        """The port that is connected, or about to be; `None` when there is none."""
        return self._port

    @property
    def starting(self) -> bool:
        """Whether the simulated board is being started, and will be connected to."""
        return self._demo_wanted

    @property
    def demo_in_use(self) -> bool:
        """Whether the simulated board was chosen last, and not given up since.

        A line that broke by itself gives nothing up: what mends it is on the board's panel.
        """
        return self._demo_in_use

    def set_settings(self, settings: ConnectionSettings) -> None:
        """Use, and remember, these line settings from the next connection on."""
        self._settings = replace(settings, url="", name="")
        self._store.setValue(_LINE, settings.line.to_wire())
        number = settings.device_number
        self._store.setValue(_NUMBER, -1 if number is None else number)
        self._store.setValue(_POLYNOMIAL, settings.polynomial)
        self.settings_changed.emit()

    def connect_to(self, port: Port) -> None:
        """Connect to a port; a line that is open is closed first, a search of the port is ended."""
        if self.finder.is_searching(port):
            self._after_search = port
            self.finder.cancel()
            return
        self._after_search = None
        self._demo_wanted = port.kind is PortKind.DEMO
        self._set_port(port)
        self._set_demo_in_use(self._demo_wanted)
        if self._demo_wanted:
            self.simulator.start()
        else:
            self._device.connect_to(replace(self._settings, url=port.url))

    def connect_with(self, port: Port, found: PortSettings) -> None:
        """Connect to a port with these line settings, and remember them."""
        settings = ConnectionSettings.on(found)
        if port.kind is PortKind.DEMO:
            self._demo_settings = replace(settings, url="", name="")
        else:
            self.set_settings(settings)
        self.connect_to(port)

    def disconnect_port(self) -> None:
        """Stop the motors if they were driven, and close the line."""
        self._after_search = None
        self._demo_wanted = False
        self._set_demo_in_use(False)
        if self._device.link is ConnectionState.DISCONNECTED:
            self._set_port(None)
        self._device.disconnect_line()

    def begin_to_shut_down(self) -> None:
        """Let line and search end, for the end of the program; waits for neither."""
        self._demo_wanted = False
        self._after_search = None
        self._device.disconnect_line()
        self.finder.cancel()

    def shut_down(self) -> bool:
        """Close the line and end the simulator, for the end of the program.

        Return whether the threads of line and search ended in time; see `Device.shut_down`.
        """
        self.begin_to_shut_down()
        ends = [self._device.shut_down(), self.finder.shut_down()]
        self.simulator.stop()
        return all(ends)

    def _set_port(self, port: Port | None) -> None:
        if port != self._port:
            self._port = port
            self.port_changed.emit()

    def _set_demo_in_use(self, in_use: bool) -> None:
        if in_use != self._demo_in_use:
            self._demo_in_use = in_use
            self.demo_changed.emit()

    def _give_demo_up(self, reason: str) -> None:
        """Connect nothing; a line that was to make room for the simulated board closes too."""
        self._demo_wanted = False
        if self._device.link is ConnectionState.DISCONNECTED:
            self._set_port(None)
        else:
            self._device.disconnect_line()
        self.failed.emit(reason)

    @Slot()
    def _on_search_finished(self) -> None:
        port, self._after_search = self._after_search, None
        if port is not None:
            self.connect_to(port)

    @Slot(str)
    def _on_simulator_ready(self, url: str) -> None:
        if self._demo_wanted and not self.simulator.plugged:
            self._give_demo_up(
                self.tr(
                    "The cable of the Demo TReX is unplugged. Tick “Plugged in” on its panel, "
                    "then connect again."
                )
            )
        elif self._demo_wanted:
            self._demo_wanted = False
            # The simulated board begins with the factory's settings, whatever is chosen here.
            settings = self._demo_settings or ConnectionSettings("", timeouts=self._timeouts)
            name = self.tr("the simulated board")
            self._device.connect_to(replace(settings, url=url, name=name))

    @Slot(str)
    def _on_simulator_failed(self, reason: str) -> None:
        if self._demo_wanted:
            self._give_demo_up(reason)
            self._set_demo_in_use(False)

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.link is ConnectionState.CONNECTED and self._port is not None:
            self._ports.note_used(self._port)
            self._note_settings(self._port)
        if self._device.link is ConnectionState.DISCONNECTED and not self._demo_wanted:
            self._set_port(None)

    def _note_settings(self, port: Port) -> None:
        """Remember how the board was reached: it may have come back at other settings."""
        if self._device.settings is None:
            return
        settings = replace(self._device.settings, url="", name="")
        if port.kind is PortKind.DEMO:
            self._demo_settings = settings
        elif settings != self._settings:
            self.set_settings(settings)

    @Slot()
    def _on_simulator_ended(self) -> None:
        self._demo_settings = None

    @Slot()
    def _on_demo_made_new(self) -> None:
        if self._demo_settings is None:
            return
        self._demo_settings = None
        if self._demo_in_use:
            self._device.expect((ConnectionSettings(""),))

    def _read_settings(self) -> ConnectionSettings:
        default = ConnectionSettings("", timeouts=self._timeouts)
        try:
            wire = int(str(self._store.value(_LINE, default.line.to_wire())))
            number = int(str(self._store.value(_NUMBER, -1)))
            polynomial = int(str(self._store.value(_POLYNOMIAL, default.polynomial)))
            settings = ConnectionSettings(
                "",
                line=LineSettings.from_wire(wire),
                device_number=None if number < 0 else number,
                polynomial=polynomial,
                timeouts=self._timeouts,
            )
            _ = settings.framing
            check_polynomial(polynomial)
        except (BadRequest, ValueError):
            return default
        return settings
