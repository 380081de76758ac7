"""How things stand between the program and a robot: one line after another."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.session.messages import Closed
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic_log import logged
from trex_gui.devices.aracna.session.messages import Connected, Halt, NotResponding, Restarted
from trex_gui.devices.aracna.session.session import AracnaSession
from trex_gui.devices.aracna.session.traffic_decoder import AracnaDecoder
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.runtime import now, open_transport
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.workers.session_thread import SessionThread


class RobotConnection(SessionThread):
    """The way to one robot, or none.

    Attributes:
        transcript: every byte that went over its line.

    Signals:
        changed: `link` or `status`.
        answered: the robot has said what it is: the `Connected`; before `link` is `CONNECTED`.
        lapsed: it does not listen, or has restarted: what servos hold is not certain any more.
        left: the line is closed, and nothing of the robot counts any more.
        failed: the error that closed the line.
    """

    changed = Signal()
    answered = Signal(object)
    lapsed = Signal()
    left = Signal()
    failed = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._link = ConnectionState.DISCONNECTED
        self._status = self.tr("Not connected.")
        self._next: PortSettings | None = None
        self.traffic = TrafficModel(self, AracnaDecoder())
        self.closed.connect(self._on_closed)

    @property
    def link(self) -> ConnectionState:
        """How things stand."""
        return self._link

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        return self._status

    def open(self, settings: PortSettings) -> None:
        """Open a line; one that is open is closed first."""
        if self.is_open:
            self.leave()
            self._next = settings
            return
        where = settings.label
        self._stand(ConnectionState.CONNECTING, self.tr("Connecting to {0} …").format(where))
        self.start(
            lambda inbox, tell: AracnaSession(
                settings, inbox, tell, logged(self.log, open_transport, now)
            ),
            may_move=False,
        )

    def leave(self) -> None:
        """Send nothing more and close the line; does not wait for it."""
        self._next = None
        if self.is_open and self._link is not ConnectionState.DISCONNECTING:
            self.submit(Halt())
            self.close()
            self._stand(ConnectionState.DISCONNECTING, self.tr("Disconnecting …"))

    def end(self) -> bool:
        """Close the line for the end of the program; return whether it ended in time."""
        self._next = None
        was_open = self.is_open
        in_time = self.shut_down()
        if was_open:
            self.left.emit()
            self._stand(ConnectionState.DISCONNECTED, self.tr("Not connected."))
        return in_time

    def follow(self, report: object) -> None:
        """Take what a report says of the link; one on its way when it was given up says nothing."""
        if self._link is ConnectionState.DISCONNECTING:
            return
        match report:
            case Connected(version=version, motors=motors):
                self.answered.emit(report)
                text = self.tr("Connected to Aracna: firmware {0}, {1} motors.")
                self._stand(ConnectionState.CONNECTED, text.format(version, motors))
            case Restarted():
                self.lapsed.emit()
                text = self.tr("The board has restarted; it listens again in a second …")
                self._stand(ConnectionState.NOT_RESPONDING, text)
            case NotResponding():
                self.lapsed.emit()
                self._stand(
                    ConnectionState.NOT_RESPONDING,
                    self.tr("The robot has stopped answering. Is its power on? Waiting for it …"),
                )
            case _:
                pass

    @Slot(object)
    def _on_closed(self, last: Closed) -> None:
        following, self._next = self._next, None
        self.left.emit()
        if following is not None:
            self.open(following)
            return
        self._stand(ConnectionState.DISCONNECTED, self.tr("Not connected."))
        if last.error is not None:
            self.failed.emit(last.error)

    def _stand(self, link: ConnectionState, status: str) -> None:
        self._link, self._status = link, status
        self.changed.emit()
