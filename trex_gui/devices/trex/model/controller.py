"""Controller of a TReX."""

from dataclasses import replace

from PySide6.QtCore import QSettings, Signal, Slot

from trex_gui.core.errors import BadRequest
from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.model.automatic_stop import AutomaticStop
from trex_gui.devices.trex.model.demo import DemoBoard
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import check_polynomial
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.controller import DeviceController
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Notifier

_LINE = "line/settings"
_NUMBER = "line/device_number"
_POLYNOMIAL = "line/polynomial"


class TrexController(DeviceController[ConnectionSettings]):
    """Remembers the line settings of boards, and reports what became of a stop.

    Signals:
        settings_changed: `settings`.
    """

    has_line_settings = True

    settings_changed = Signal()

    def __init__(
        self,
        plugin: DevicePlugin,
        device: Device,
        ports: Ports,
        scanner: DeviceScanner,
        timeouts: Timeouts | None = None,
    ) -> None:
        self._default = ConnectionSettings("", timeouts=timeouts or Timeouts())
        super().__init__(plugin, device, ports, scanner, self._default)
        self.device = device
        self._store = QSettings(self)
        self.settings = self._read_settings()
        self.demo_board = DemoBoard(self.simulator, self)
        self._automatic_stop = AutomaticStop(device, self)

        self._automatic_stop.reported.connect(self.stop_reported)
        self.settings_changed.connect(self.changed)
        self.simulator.ended.connect(self._on_simulator_ended)
        self.demo_board.factory_reset.connect(self._on_demo_factory_reset)
        device.link_changed.connect(self._note_settings)
        device.progressed.connect(self.progressed)

    # --- Line settings ------------------------------------------------------------------

    @property
    def line_text(self) -> str:
        number = self.settings.device_number
        return self.settings.short if number is None else f"{self.settings.short} #{number}"

    def set_settings(self, settings: ConnectionSettings) -> None:
        """Use and remember these line settings from the next connection on."""
        self.settings = replace(settings, url="", name="")
        self._store.setValue(_LINE, settings.line.to_wire())
        number = settings.device_number
        self._store.setValue(_NUMBER, -1 if number is None else number)
        self._store.setValue(_POLYNOMIAL, settings.polynomial)
        self.settings_changed.emit()

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        found = ConnectionSettings.on(settings)
        if port.kind is PortKind.DEMO:
            self._demo_settings = found
        else:
            self.set_settings(found)
        self.connect_to(port)

    @Slot()
    def _note_settings(self) -> None:
        """Remember how the board was reached: it may have come back at other settings."""
        used, port = self.device.settings, self.port
        if self.link is not ConnectionState.CONNECTED or used is None or port is None:
            return
        settings = replace(used, url="", name="")
        if port.kind is PortKind.DEMO:
            self._demo_settings = settings
        elif settings != self.settings:
            self.set_settings(settings)

    @Slot()
    def _on_simulator_ended(self) -> None:
        """A new simulated board starts with factory settings, whatever is chosen here."""
        self._demo_settings = self._default

    @Slot()
    def _on_demo_factory_reset(self) -> None:
        self._demo_settings = self._default
        if self.demo_in_use:
            self.device.expect((ConnectionSettings(""),))

    def _read_settings(self) -> ConnectionSettings:
        try:
            wire = int(str(self._store.value(_LINE, self._default.line.to_wire())))
            number = int(str(self._store.value(_NUMBER, -1)))
            polynomial = int(str(self._store.value(_POLYNOMIAL, self._default.polynomial)))
            settings = replace(
                self._default,
                line=LineSettings.from_wire(wire),
                device_number=None if number < 0 else number,
                polynomial=check_polynomial(polynomial),
            )
            _ = settings.framing
        except (BadRequest, ValueError):
            return self._default
        return settings

    # --- Stopping -----------------------------------------------------------------------

    @property
    def is_busy(self) -> bool:
        return self.device.applying

    @property
    def may_move(self) -> bool:
        return self.device.may_move

    @property
    def unconfirmed_stop(self) -> str:
        if self.link is not ConnectionState.DISCONNECTED or not self.may_move:
            return ""
        return self.tr("The stop is not confirmed. If a motor still turns, cut its power.")

    def press_stop(self) -> None:
        self.device.motors.press_stop()

    def stop_because(self, reason: str) -> str:
        return self._automatic_stop.stop(reason)

    def stop_now(self, *, ending: bool = False) -> None:
        self.device.stop_now(ending=ending)


def make_controller(
    plugin: DevicePlugin,
    notifier: Notifier,
    ports: Ports,
    scanner: DeviceScanner,
    timeouts: Timeouts,
) -> TrexController:
    """Make the model of a device and its controller."""
    return TrexController(plugin, Device(notifier), ports, scanner, timeouts)
