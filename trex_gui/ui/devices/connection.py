"""Connection to a device, and its state."""

from enum import Enum, auto
from functools import partial
from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import BadReply, NoReply, PortShared
from trex_gui.core.session import Closed
from trex_gui.core.translation import tr
from trex_gui.core.transport.linux_ports import other_user_of
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic import Decoder, logged
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Remedy
from trex_gui.ui.runtime import now, open_transport
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.workers.session_thread import SessionFactory, SessionThread

SettingsT = TypeVar("SettingsT", bound=PortSettings)


class ConnectionState(Enum):
    DISCONNECTED = auto()
    CONNECTING = auto()
    CONNECTED = auto()
    NOT_RESPONDING = auto()
    DISCONNECTING = auto()


class DeviceConnection(SessionThread, Generic[SettingsT]):
    """Base class of connections. A subclass creates the session and handles its reports.

    `line_closed` is emitted before `link` changes. `failed` is emitted after `changed`.
    """

    changed = Signal()  # `link` or `status` has changed
    line_closed = Signal(object)  # `Closed`; `None` if the session has not ended in time
    interfered = Signal(str, object)  # sentence about another user of the port, `Remedies`
    failed = Signal(object)  # the `StudioError` that closed the line

    def __init__(self, decoder: Decoder, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.link = ConnectionState.DISCONNECTED
        self.status = tr("Not connected.")  # `link` as a sentence
        self.settings: SettingsT | None = None  # settings of the open or last line
        self._next: SettingsT | None = None  # settings of the line that will be opened next
        self.open_logged = logged(self.log.record, open_transport, now)
        self.traffic = TrafficModel(self, decoder)  # every byte on the line
        self.reported.connect(self.handle)
        self.closed.connect(self._on_closed)

    def open(self, settings: SettingsT, *, may_move: bool = False) -> None:
        """Open a line. `may_move`: motors may still be turning from an earlier session."""
        if self.is_open:
            self.close()
            self._next = settings
            return
        self.settings = settings
        create_session = self.new_session(settings, may_move=may_move)
        text = tr("Connecting to {0} …").format(settings.text())
        self._set_state(ConnectionState.CONNECTING, text)
        self.start(create_session, may_move=may_move)

    def close(self) -> None:
        """Stop the motors if possible, and close the line. Does not wait."""
        self._next = None
        if self.is_open and self.link is not ConnectionState.DISCONNECTING:
            self.prepare_to_close()
            super().close()
            self._set_state(ConnectionState.DISCONNECTING, tr("Disconnecting …"))

    def shut_down(self) -> bool:
        self._next = None
        was_open = self.is_open
        in_time = super().shut_down()
        if was_open:
            self.line_closed.emit(self.last)
            self._set_state(ConnectionState.DISCONNECTED, tr("Not connected."))
        return in_time

    # --- Defined by subclasses ------------------------------------------------------------

    def new_session(self, settings: SettingsT, *, may_move: bool) -> SessionFactory:
        """Reset the data of the last session. Return a function that creates the next session."""
        raise NotImplementedError

    def prepare_to_close(self) -> None:
        """Prepare for the end of the session. Does nothing by default."""

    def handle(self, report: object) -> None:
        raise NotImplementedError

    def _set_state(self, link: ConnectionState, status: str) -> None:
        stopped_responding = link is ConnectionState.NOT_RESPONDING is not self.link
        self.link, self.status = link, status
        self.changed.emit()
        if stopped_responding:
            self._detect_other_program()

    def _detect_other_program(self) -> None:
        if self.settings is None:
            return
        link, url, name = self.link, self.settings.url, self.settings.label

        def report(program: str | None) -> None:
            if program is None or self.link is not link:
                return
            text = tr("{0} also has {1} open and may take replies. Close the port there.")
            is_closed = link is ConnectionState.DISCONNECTED
            remedies = (Remedy.RECONNECT,) if is_closed else ()
            self.interfered.emit(text.format(program, name), remedies)

        in_background(self, partial(other_user_of, url), report, lambda _error: None)

    @Slot(object)
    def _on_closed(self, last: Closed) -> None:
        next_settings, self._next = self._next, None
        self.line_closed.emit(last)
        if next_settings is not None:
            self.open(next_settings, may_move=last.may_move)
            return
        self._set_state(ConnectionState.DISCONNECTED, tr("Not connected."))
        if last.error is not None:
            self.failed.emit(last.error)
            if isinstance(last.error, NoReply | BadReply | PortShared):
                self._detect_other_program()
