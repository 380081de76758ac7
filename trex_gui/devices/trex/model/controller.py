"""How a TReX is reached, for a window that knows several kinds of devices."""

from PySide6.QtCore import QObject, Signal

from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.model.automatic_stop import AutomaticStop
from trex_gui.devices.trex.model.connector import Connector
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.device_kind import TREX, DeviceKind
from trex_gui.ui.devices.ports import Port


class TrexController(QObject):
    """A device and its connector as one; see `device_manager.Way`."""

    changed = Signal()
    progressed = Signal(int, int, str)
    stop_reported = Signal(str)

    def __init__(self, device: Device, connector: Connector, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._connector = connector
        self._unasked = AutomaticStop(device, self)
        self._unasked.told.connect(self.stop_reported)
        device.link_changed.connect(self.changed)
        device.progressed.connect(self.progressed)
        connector.port_changed.connect(self.changed)
        connector.settings_changed.connect(self.changed)

    @property
    def kind(self) -> DeviceKind:
        """TReX."""
        return TREX

    @property
    def link(self) -> ConnectionState:
        """How things stand."""
        return self._device.link

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        return self._device.status

    @property
    def starting(self) -> bool:
        """Whether the simulated board is being started, and will be connected to."""
        return self._connector.starting

    @property
    def port(self) -> Port | None:
        """The port that is connected, or about to be."""
        return self._connector.port

    @property
    def demo_in_use(self) -> bool:
        """Whether the simulated board was chosen last, and not given up since."""
        return self._connector.demo_in_use

    @property
    def has_line_settings(self) -> bool:
        """A TReX can be set to any baud rate, with parity or CRC."""
        return True

    @property
    def is_busy(self) -> bool:
        """Whether settings are being written."""
        return self._device.applying

    @property
    def line_text(self) -> str:
        """Line settings and device number for the next connection."""
        settings = self._connector.settings
        number = settings.device_number
        return settings.short if number is None else f"{settings.short} #{number}"

    def connect_to(self, port: Port) -> None:
        """Connect to a port."""
        self._connector.connect_to(port)

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        """Connect to a port with these line settings, and remember them."""
        self._connector.connect_with(port, settings)

    def leave(self) -> None:
        """Stop the motors if they were driven, and close the line."""
        self._connector.disconnect_port()

    def press_stop(self) -> None:
        """Stop the motors, and lock them for a while."""
        self._device.motors.press_stop()

    def stop_because(self, reason: str) -> str:
        """Stop the motors; `stop_reported` tells whether the board has confirmed it."""
        return self._unasked.stop(reason)

    @property
    def unconfirmed_stop(self) -> str:
        """A stop that no board has confirmed, where the line is closed."""
        if self._device.link is not ConnectionState.DISCONNECTED or not self._device.may_move:
            return ""
        return self.tr("The stop is not confirmed. If a motor still turns, cut its power.")

    def begin_to_shut_down(self) -> None:
        """Stop the motors if they were driven, and let line and search end."""
        self._connector.begin_to_shut_down()

    def shut_down(self) -> bool:
        """Close the line and end the simulator; return whether it ended in time."""
        return self._connector.shut_down()
