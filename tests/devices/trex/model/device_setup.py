"""Device without a window, and its simulated board."""

from collections.abc import Callable

from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now


class DeviceSetup:
    """Device that is not connected at first, and its simulated board."""

    def __init__(
        self, qtbot: QtBot, simulator: SimulatedDevice, device: Device | None = None
    ) -> None:
        self.qtbot = qtbot
        self.simulator = simulator
        self.device = device or Device()

    def until(self, condition: Callable[[], object]) -> None:
        self.qtbot.waitUntil(lambda: bool(condition()))

    def until_link(self, link: ConnectionState) -> None:
        self.until(lambda: self.device.link is link)

    def pass_time(self, seconds: float) -> None:
        end = now() + seconds
        self.until(lambda: now() > end)

    def connect(self, url: str = "") -> None:
        self.device.connect_to(ConnectionSettings(url or self.simulator.url))
        self.until_link(ConnectionState.CONNECTED)

    def cycle_power(self, *while_off: str) -> None:
        """Cycle the power of the board. Send control lines while it is off."""
        self.simulator.do("power off")
        self.until_link(ConnectionState.NOT_RESPONDING)
        self.simulator.do(*while_off, "power on")
        self.until_link(ConnectionState.CONNECTED)

    def disconnect(self) -> None:
        self.device.disconnect_line()
        self.until_link(ConnectionState.DISCONNECTED)

    def write(self, *keys: str) -> None:
        """Apply the edits, or only edits with these keys, and wait for the end."""
        self.device.writer.apply(keys or None)
        self.until(lambda: not self.device.writer.running)

    def shut_down(self) -> None:
        """Shut down the device. No thread may outlive a test."""
        self.until(self.device.shut_down)
