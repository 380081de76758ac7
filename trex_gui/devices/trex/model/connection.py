"""Connection to a board."""

import logging
from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Close, Outcome, Progress
from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.requests import (
    CommandsRepeated,
    MotorsStopped,
    SetpointRequest,
    Stop,
    StopSent,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    BoardElsewhere,
    ErrorCode,
    TrexError,
    suggests_inspection,
    suggests_scan,
)
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    GuardianChanged,
    Job,
    LeaseChanged,
    NetworkDelay,
    NotResponding,
    OfBoard,
    ProbeProgress,
    SelectBoard,
    SendPacket,
    SetpointsChanged,
    SetReconnectCandidates,
    SetWatched,
    ToBoard,
    Traffic,
    Write,
)
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.ui.devices.connection import ConnectionState, DeviceConnection
from trex_gui.ui.notifier import ConnectWith, Remedies, Remedy, remedies_of
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.session_thread import NO_HANDLER, SessionFactory

log = logging.getLogger(__name__)


class Connection(DeviceConnection[ConnectionSettings]):
    device_read = Signal(object)  # a `Connected`: the board was read
    ready = Signal()  # `link` is now `CONNECTED`; emitted after `device_read`
    leaving = Signal()  # emitted before the line is closed or another board is selected
    not_responding = Signal(object)  # a `NotResponding`
    guardian_changed = Signal()  # `is_guarded`
    stop_sent = Signal()  # a stop was sent, but it is not confirmed yet
    motors_stopped = Signal(object)  # a `MotorsStopped`: the session itself stopped motors
    commands_repeated = Signal(object)  # a `CommandsRepeated`
    sampled = Signal(object)  # a `Batch`
    served = Signal(object)  # a report that only the server of a board sends
    member_reported = Signal(int, object)  # number and report of another board in the group
    progressed = Signal(int, int, str)  # steps done, total steps, next step

    def __init__(self, parent: QObject | None = None) -> None:
        self._decoder = TrexDecoder()
        super().__init__(self._decoder, parent)
        self.port_rates: frozenset[int] | None = None  # rates of the port; `None` if unknown
        self.selection = 0  # see `Connected.selection`
        self.is_guarded = False  # the guardian process is ready
        self._watchers = {"window"}
        self._relayed = {  # reports that are relayed unchanged
            Batch: self.sampled,
            MotorsStopped: self.motors_stopped,
            CommandsRepeated: self.commands_repeated,
            **dict.fromkeys((LeaseChanged, SetpointsChanged, NetworkDelay), self.served),
        }
        self.started.connect(self._submit_watched)

    def watch(self, watcher: str, watching: bool) -> None:
        """Add or remove a watcher. Poll at the full rate while there are watchers."""
        was_watched = bool(self._watchers)
        (self._watchers.add if watching else self._watchers.discard)(watcher)
        if bool(self._watchers) != was_watched:
            self._submit_watched()

    @Slot()
    def _submit_watched(self) -> None:
        self.submit(SetWatched(bool(self._watchers), traffic=bool(self._watchers)))

    def expect(self, settings: tuple[ConnectionSettings, ...]) -> None:
        """Set the line settings for reconnect attempts."""
        self.submit(SetReconnectCandidates(settings))

    def moves(self, request: object) -> bool:
        if isinstance(request, ToBoard):
            return self.moves(request.request)
        if isinstance(request, SendPacket):
            return request.packet.moves
        return isinstance(request, SetpointRequest)

    def writes(self, request: object) -> bool:
        if isinstance(request, ToBoard):
            return self.writes(request.request)
        return isinstance(request, Write)

    def new_session(self, settings: ConnectionSettings, *, may_move: bool) -> SessionFactory:
        from trex_gui.devices.trex.serve.sessions import session_at  # noqa: PLC0415 - slow to import

        self.is_guarded = False
        return lambda inbox, emit: session_at(
            settings, inbox, emit, self.open_logged, now, may_move=may_move
        )

    def prepare_to_close(self) -> None:
        self.leaving.emit()

    def select(self, number: int, known: tuple[int, ...], then: Callable[[Outcome], None]) -> None:
        """Address another board on the open line.

        `link` is `CONNECTING` until the board is read. `known` contains the numbers of all known
        boards. If the selection fails, `link` and `status` are restored.
        """
        before = self.link, self.status

        def report(outcome: Outcome) -> None:
            if outcome.error is not None and self.link is ConnectionState.CONNECTING:
                self._set_state(*before)
                if before[0] is ConnectionState.CONNECTED:
                    self.ready.emit()
            then(outcome)

        self.leaving.emit()
        self._set_state(ConnectionState.CONNECTING, tr("Selecting device {0} …").format(number))
        self.request(lambda request: SelectBoard(request, number, known), report)

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop every motor. With `ending`, also close the port. Thread-safe.

        Does not wait, and reports nothing. Call `Motors.stop` next, in the window's thread.
        Setpoints queued after the stop are dropped until the motors are armed again.
        """
        stop = Stop(NO_HANDLER)
        self.submit_now(*((stop, Close()) if ending else (stop,)))

    def handle(self, report: object) -> None:
        if (relay := self._relayed.get(type(report))) is not None:
            relay.emit(report)
            return
        match report:
            case OfBoard(report=Outcome() as outcome):
                self.deliver(outcome)
            case OfBoard(number=number, report=other_report):
                self.member_reported.emit(number, other_report)
            case GuardianChanged(is_ready=is_ready):
                self.is_guarded = is_ready
                self.guardian_changed.emit()
            case Traffic(events=events):  # from the server of a board
                for event in events:
                    self.log.record(event)
            case StopSent():
                self.stop_sent.emit()
            case Connected() | NotResponding() | Progress() if (
                self.link is ConnectionState.DISCONNECTING
            ):
                pass  # queued before the line was closed
            case Progress(done=done, total=total, what=what):
                if isinstance(report, ProbeProgress):
                    text = tr("No reply yet. Trying other settings: {0} …").format(what)
                    self._set_state(ConnectionState.CONNECTING, text)
                self.progressed.emit(done, total, what)
            case Connected():
                self._handle_state(report)
            case NotResponding(reason=reason):
                log.info("the board does not respond: %s", reason)
                self.not_responding.emit(report)
                text = tr(
                    "The board has stopped responding. Check its power. Waiting for a reply …"
                )
                self._set_state(ConnectionState.NOT_RESPONDING, text)

    def _handle_state(self, report: Connected) -> None:
        self.settings = report.settings
        self.port_rates = report.port_rates
        self.selection = report.selection
        self.traffic.record_settings(report.settings, echo=report.echo)
        signature = report.state.signature
        if self._decoder.board != signature:
            self._decoder.board = signature
            self.traffic.decode_again()
        self.device_read.emit(report)
        self._set_state(ConnectionState.CONNECTED, tr("Connected to {0}.").format(signature))
        self.ready.emit()


class MemberConnection(Connection):
    """Connection to another board in the group of `main`."""

    def __init__(self, main: Connection, number: int, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._main, self._number = main, number
        main.member_reported.connect(self._on_report)
        main.line_closed.connect(self._on_line_closed)

    @property
    def is_open(self) -> bool:
        return self._main.is_open

    def submit(self, request: object) -> bool:
        """Queue a `Job`. Ignore other requests, because only the main connection drives motors."""
        if isinstance(request, Job):
            return self._main.submit(ToBoard(self._number, request))
        return False

    def request(self, make: Callable[[int], object], then: Callable[[Outcome], None]) -> bool:
        request = make(0)
        if not isinstance(request, Job):
            return False
        return self._main.request(
            lambda number: ToBoard(self._number, replace(request, id=number)), then
        )

    @Slot(int, object)
    def _on_report(self, number: int, report: object) -> None:
        if number == self._number:
            self.handle(report)
            self.reported.emit(report)

    @Slot(object)
    def _on_line_closed(self, last: object) -> None:
        self.line_closed.emit(last)
        self._set_state(ConnectionState.DISCONNECTED, tr("Not connected."))


def remedies_for(error: StudioError) -> Remedies:
    if isinstance(error, BoardElsewhere):
        return (ConnectWith(error.settings),)
    if isinstance(error, TrexError) and error.code is ErrorCode.BOOT_LOADER:
        return Remedy.RECONNECT, Remedy.CHECK_BOARD
    if isinstance(error, TrexError) and error.code is ErrorCode.REPLIES_LOST:
        return (Remedy.RECONNECT,)
    remedies = remedies_of(error, may_be_found=suggests_scan(error))
    return (*remedies, Remedy.CHECK_BOARD) if suggests_inspection(error) else remedies
