"""Connection to a robot."""

from PySide6.QtCore import QObject, Signal

from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.session.messages import Connected, Halt, NotResponding, Restarted
from trex_gui.devices.aracna.session.session import AracnaSession
from trex_gui.devices.aracna.session.traffic_decoder import AracnaDecoder
from trex_gui.ui.devices.connection import DeviceConnection
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.workers.line_worker import MakeSession


class RobotConnection(DeviceConnection[PortSettings]):
    """The line to one robot, or none.

    Signals:
        device_read: the robot has said what it is: the `Connected`; before `link` changes.
        state_lost: it does not listen, or has restarted: what servos hold is uncertain.
    """

    device_read = Signal(object)
    state_lost = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(AracnaDecoder(), parent)

    def new_session(self, settings: PortSettings, *, may_move: bool) -> MakeSession:
        del may_move  # a motion ends by itself
        return lambda inbox, emit: AracnaSession(settings, inbox, emit, self.open_logged)

    def prepare_to_close(self) -> None:
        self.submit(Halt())

    def take(self, report: object) -> None:
        if self.link is ConnectionState.DISCONNECTING:
            return  # it was on its way when the line was closed
        match report:
            case Connected(version=version, motors=motors):
                self.device_read.emit(report)
                text = self.tr("Connected to Aracna: firmware {0}, {1} motors.")
                self._set_state(ConnectionState.CONNECTED, text.format(version, motors))
            case Restarted():
                self.state_lost.emit()
                text = self.tr("The board has restarted; it listens again in a second …")
                self._set_state(ConnectionState.NOT_RESPONDING, text)
            case NotResponding():
                self.state_lost.emit()
                text = self.tr("The robot has stopped answering. Is its power on? Waiting for it …")
                self._set_state(ConnectionState.NOT_RESPONDING, text)
            case _:
                pass
