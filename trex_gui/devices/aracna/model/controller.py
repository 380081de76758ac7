"""How an Aracna is reached, for a window that knows several kinds of devices."""

from dataclasses import replace

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.model.automatic_stop import halt_because
from trex_gui.devices.aracna.model.demo_robot import DemoRobot
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.protocol.commands import BAUD
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.device_kind import DeviceKind
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator_process import Simulator

ARACNA = DeviceKind("aracna", "Aracna")

LINE = SerialFormat(BAUD)
"""The firmware knows no other."""


class AracnaController(QObject):
    """A robot, and the simulated one, as one; see `device_manager.Way`.

    Signals:
        changed: anything of what stands below.
        progressed: never told: a robot answers at once or not at all.
        stop_told: never told: no answer says more of a halt than is known at once.
        failed: why nothing was connected, for people.
    """

    changed = Signal()
    progressed = Signal(int, int, str)
    stop_reported = Signal(str)
    failed = Signal(str)

    def __init__(
        self,
        robot: Robot,
        ports: Ports,
        finder: DeviceScanner,
        parent: QObject | None = None,
        *,
        timeouts: Timeouts | None = None,
    ) -> None:
        super().__init__(parent)
        self._timeouts = timeouts or Timeouts()
        self._robot = robot
        self._ports = ports
        self._finder = finder
        self._port: Port | None = None
        self._demo_wanted = False
        self._demo_in_use = False
        self._after_search: Port | None = None
        self.simulator = Simulator(self, arguments=("--aracna",))
        self.demo_robot = DemoRobot(self.simulator, self)

        self.simulator.ready.connect(self._on_simulator_ready)
        self.simulator.failed.connect(self._on_simulator_failed)
        finder.finished.connect(self._on_search_finished)
        robot.link_changed.connect(self._on_link_changed)

    @property
    def kind(self) -> DeviceKind:
        """Aracna."""
        return ARACNA

    @property
    def link(self) -> ConnectionState:
        """How things stand."""
        return self._robot.link

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        return self._robot.status

    @property
    def starting(self) -> bool:
        """Whether the simulated robot is being started, and will be connected to."""
        return self._demo_wanted

    @property
    def port(self) -> Port | None:
        """The port that is connected, or about to be."""
        return self._port

    @property
    def demo_in_use(self) -> bool:
        """Whether the simulated robot was chosen last, and not given up since."""
        return self._demo_in_use

    @property
    def demo_name(self) -> str:
        """What people call the simulated robot."""
        return self.tr("the simulated robot")

    @property
    def has_line_settings(self) -> bool:
        """The firmware has one baud rate."""
        return False

    @property
    def is_busy(self) -> bool:
        """Nothing is stored in this robot that could be cut off."""
        return False

    @property
    def line_text(self) -> str:
        """How the line is set, always."""
        return PortSettings("", line=LINE).short

    def connect_to(self, port: Port) -> None:
        """Connect to a port; a line that is open is closed first, a search of the port is ended."""
        if self._finder.is_searching(port):
            self._after_search = port
            self._finder.cancel()
            return
        self._after_search = None
        self._port = port
        self._demo_wanted = self._demo_in_use = port.kind is PortKind.DEMO
        if self._demo_wanted:
            self.simulator.start()
        else:
            self._robot.connect_to(PortSettings(port.url, line=LINE, timeouts=self._timeouts))
        self.changed.emit()

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        """Connect to a port at which a robot was found; its line is never set otherwise."""
        del settings
        self.connect_to(port)

    def leave(self) -> None:
        """Send nothing more and close the line; a motion that runs ends by itself."""
        self._after_search = None
        self._demo_wanted = self._demo_in_use = False
        if self._robot.link is ConnectionState.DISCONNECTED:
            self._port = None
            self.changed.emit()
        self._robot.disconnect_line()

    def press_stop(self) -> None:
        """End what is played and send nothing more; what moves goes on to its goal."""
        self._robot.halt()

    def stop_because(self, reason: str) -> str:
        """End what is played and send nothing more; say how long what moves goes on."""
        return halt_because(self._robot, reason)

    @property
    def unconfirmed_stop(self) -> str:
        """Nothing: no stop can be asked of this robot, which is told wherever one is pressed."""
        return ""

    def begin_to_shut_down(self) -> None:
        """Send nothing more, and let the line end."""
        self._demo_wanted = False
        self._after_search = None
        self._robot.disconnect_line()

    def shut_down(self) -> bool:
        """Close the line and end the simulator; return whether it ended in time."""
        self.begin_to_shut_down()
        in_time = self._robot.shut_down()
        self.simulator.stop()
        return in_time

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
                    "The cable of the Demo Aracna is unplugged. Tick “Plugged in” on its panel, "
                    "then connect again."
                )
            )
        elif self._demo_wanted:
            self._demo_wanted = False
            settings = PortSettings(url, line=LINE, timeouts=self._timeouts)
            self._robot.connect_to(replace(settings, name=self.demo_name))

    @Slot(str)
    def _on_simulator_failed(self, reason: str) -> None:
        if self._demo_wanted:
            self._demo_in_use = False
            self._give_demo_up(reason)

    def _give_demo_up(self, reason: str) -> None:
        """Connect nothing; a line that was to make room for the simulated robot closes too."""
        self._demo_wanted = False
        if self._robot.link is ConnectionState.DISCONNECTED:
            self._port = None
        else:
            self._robot.disconnect_line()
        self.changed.emit()
        self.failed.emit(reason)

    @Slot()
    def _on_link_changed(self) -> None:
        if self._robot.link is ConnectionState.CONNECTED and self._port is not None:
            self._ports.note_used(self._port)
        if self._robot.link is ConnectionState.DISCONNECTED and not self._demo_wanted:
            self._port = None
        self.changed.emit()
