"""Controller that connects and disconnects a device."""

from dataclasses import dataclass, replace
from typing import Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, Signal, SignalInstance, Slot

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.devices.connection import ConnectionState, SettingsT
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator import Simulator
from trex_gui.ui.notifier import Notifier, Remedies, Remedy
from trex_gui.ui.traffic.model import TrafficModel

SettingsT_contra = TypeVar("SettingsT_contra", bound=PortSettings, contravariant=True)


class DeviceModel(Protocol[SettingsT_contra]):
    """Part of a device's model that its controller uses. See `DeviceConnection`."""

    notifier: Notifier

    @property
    def link_changed(self) -> SignalInstance: ...
    @property
    def link(self) -> ConnectionState: ...
    @property
    def status(self) -> str: ...
    @property
    def settings(self) -> PortSettings | None: ...

    def connect_to(self, settings: SettingsT_contra) -> None: ...
    def disconnect_line(self) -> None: ...
    def shut_down(self) -> bool: ...


@dataclass(frozen=True, slots=True)
class QualityReport:
    """Quality of a line as text. `is_bad`: the user should improve the line."""

    text: str = ""  # empty if unknown
    is_bad: bool = False
    remedy: Remedy | None = None


class DeviceController(QObject, Generic[SettingsT]):
    has_line_settings = False  # True if the user can change the line settings

    changed = Signal()  # any property may have changed
    progressed = Signal(int, int, str)  # completed steps, total steps, next step
    stop_reported = Signal(str)  # sentences about the progress of a stop

    def __init__(
        self,
        plugin: DevicePlugin,
        model: DeviceModel[SettingsT],
        ports: Ports,
        scanner: DeviceScanner,
        default: SettingsT,
    ) -> None:
        super().__init__()
        self.plugin = plugin
        self._model = model
        self.ports = ports
        self._scanner = scanner
        # Settings of the next connection, without a port address.
        self.settings = self._demo_settings = default
        self.port: Port | None = None  # port that is connected or being connected
        self._selected: Port | None = None
        self.starting = False  # the simulator is starting; the connection follows
        # True from the connection to the simulated device until the user disconnects. A broken
        # line does not reset it, because the user repairs the line in the demo panel.
        self.demo_in_use = False
        self._after_scan: Port | None = None
        self.simulator = Simulator(plugin, self)
        scanner.add_simulator(plugin.key, self.simulator)

        self.simulator.ready.connect(self._on_simulator_ready)
        self.simulator.failed.connect(self._on_simulator_failed)
        scanner.finished.connect(self._on_scan_finished)
        model.link_changed.connect(self._on_link_changed)

    @property
    def link(self) -> ConnectionState:
        return self._model.link

    @property
    def status(self) -> str:
        return self._model.status

    @property
    def line_text(self) -> str:
        return self.settings.short

    def select(self, port: Port) -> None:
        """Select a port. If the port is new, use the settings of the device found there."""
        if self._selected is None or not self._selected.is_same(port):
            self._selected = port
            if port.settings:
                self.set_packed(port.settings)

    def connect_to(self, port: Port) -> None:
        """Connect to a port after closing an open line and ending a scan of the port."""
        self.select(port)
        if self._scanner.is_scanning(port):
            self._after_scan = port
            self._scanner.cancel()
            return
        self._after_scan = None
        self.port = port
        self.starting = self.demo_in_use = port.kind is PortKind.DEMO
        self.changed.emit()
        if self.starting:
            self.simulator.start()
        else:
            self._model.connect_to(replace(self.settings, url=port.url))

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        """Connect to a port at which a scan found a device with these settings."""
        del settings  # used by devices with more than one line setting
        self.connect_to(port)

    def disconnect_device(self) -> None:
        self._after_scan = None
        self.starting = self.demo_in_use = False
        if self.link is ConnectionState.DISCONNECTED:
            self.port = None
        self.changed.emit()
        self._model.disconnect_line()

    def start_shutdown(self) -> None:
        self.starting = False
        self._after_scan = None
        self._model.disconnect_line()

    def shut_down(self) -> bool:
        """Close the line and end the simulator. Return False if the line does not close in time."""
        self.start_shutdown()
        in_time = self._model.shut_down()
        self.simulator.stop()
        return in_time

    def _abandon_demo(self, reason: str, remedies: Remedies = ()) -> None:
        self.starting = False
        if self.link is ConnectionState.DISCONNECTED:
            self.port = None
        else:
            self._model.disconnect_line()
        self.changed.emit()
        self._model.notifier.report(reason, remedies)

    def show_searches_in(self, traffic: TrafficModel) -> None:
        self._traffic = traffic
        self._scanner.logs.append(traffic.search_log)
        self._scanner.changed.connect(self._on_scan_changed)

    @Slot()
    def _on_scan_changed(self) -> None:
        self._traffic.set_searching(self._scanner.running)

    @Slot()
    def _on_scan_finished(self) -> None:
        port, self._after_scan = self._after_scan, None
        if port is not None:
            self.connect_to(port)

    @Slot(str)
    def _on_simulator_ready(self, url: str) -> None:
        if not self.starting:
            return
        if not self.simulator.plugged:
            text = tr(
                "The cable of the Demo {0} is unplugged. Plug the cable in on the demo "
                "panel, then connect again."
            )
            self._abandon_demo(text.format(self.plugin.name), (Remedy.RECONNECT,))
            return
        self.starting = False
        settings = replace(self._demo_settings, url=url, name=self.simulator.label)
        self._model.connect_to(settings)

    @Slot(str)
    def _on_simulator_failed(self, reason: str) -> None:
        if self.starting:
            self.demo_in_use = False
            self._abandon_demo(reason)

    @Slot()
    def _on_link_changed(self) -> None:
        if self.link is ConnectionState.CONNECTED and self.port is not None:
            used = self._model.settings
            self.ports.assign(self.port, self.plugin.key, used.packed if used else "")
        if self.link is ConnectionState.DISCONNECTED and not self.starting:
            self.port = None
        self.changed.emit()

    # --- Defined by subclasses ------------------------------------------------------------

    def set_packed(self, settings: str) -> None:
        """Use the packed settings of a found device. Does nothing by default."""

    @property
    def quality(self) -> QualityReport:
        return QualityReport()

    @property
    def is_busy(self) -> bool:
        """True if disconnecting now would interrupt a write."""
        return False

    @property
    def is_armed(self) -> bool:
        """True if setpoints are sent."""
        return False

    @property
    def may_move(self) -> bool:
        """True if motors were driven and no stop has been confirmed since then."""
        return False

    @property
    def unconfirmed_stop(self) -> str:
        """Warning if motors may still be turning although the line is closed. Otherwise empty."""
        return ""

    @property
    def needs_stop(self) -> bool:
        """True if Esc must stop the device even when it closes a dialog or menu."""
        return self.link is not ConnectionState.DISCONNECTED

    def press_stop(self) -> None:
        raise NotImplementedError

    def stop_because(self, reason: str) -> str:
        """Stop because of an event.

        `reason`: clause without a period, such as "The screen was locked". Return sentences about
        the stop. The first sentence starts with the reason. If there is nothing to stop, return an
        empty text.
        """
        raise NotImplementedError

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop without waiting. Can be called from any thread. `ending`: also close the port."""
        raise NotImplementedError
