"""How things stand between the program and a board: one line after another, and what it says."""

import logging
from collections.abc import Callable, Mapping
from dataclasses import replace

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.session.messages import Closed, Outcome, Progress
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.driving.requests import MotorsStopped, Stop
from trex_gui.devices.trex.model.line import Line
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    NotResponding,
    Reload,
    Report,
    Request,
    Write,
)
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.traffic.model import TrafficModel

log = logging.getLogger(__name__)


class Connection(QObject):
    """The way to one board, or none.

    Attributes:
        transcript: every byte that went over its line.

    What `answered`, `closing`, `silenced` and `left` tell is known before `link` says so, and
    `changed` follows.

    Signals:
        changed: `link` and `status`.
        answered: the board was read, or read anew: the `Connected`.
        settled: what `answered` told is taken in, and `link` is `CONNECTED`.
        closing: the line is about to be closed, as was asked.
        silenced: the board has stopped answering.
        left: the line is closed, and nothing of the board counts any more: the `Closed`; `None`
            at the end of the program, where the session does not end in time.
        halted: the line session has stopped the motors by itself: the `MotorsStopped`.
        sampled: a `Batch`.
        progressed: steps done, steps in all, what comes next.
        failed: why the line is closed, for people.
    """

    changed = Signal()
    answered = Signal(object)
    settled = Signal()
    closing = Signal()
    silenced = Signal()
    left = Signal(object)
    halted = Signal(object)
    sampled = Signal(object)
    progressed = Signal(int, int, str)
    failed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._link = ConnectionState.DISCONNECTED
        self._status = self.tr("Not connected.")
        self._settings: ConnectionSettings | None = None
        self._echo = False
        self._port_rates: frozenset[int] | None = None
        self._counters = Counters()
        self._next: ConnectionSettings | None = None
        self._line = Line(self)
        self._wording = TrexDecoder()
        self.traffic = TrafficModel(self._line, self._wording)
        self._line.reported.connect(self._on_reported)
        self._line.closed.connect(self._on_closed)

    # --- What is known ------------------------------------------------------------------

    @property
    def link(self) -> ConnectionState:
        """How things stand."""
        return self._link

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        return self._status

    @property
    def is_open(self) -> bool:
        """Whether a session owns the port, or is about to."""
        return self._line.is_open

    @property
    def settings(self) -> ConnectionSettings | None:
        """How the line is, or was last, opened."""
        return self._settings

    @property
    def echo(self) -> bool:
        """Whether everything sent comes back: the RS-232 side of the board."""
        return self._echo

    @property
    def port_rates(self) -> frozenset[int] | None:
        """The baud rates that this computer's port can do; `None`: unknown."""
        return self._port_rates

    @property
    def counters(self) -> Counters:
        """What the line has seen since it was opened."""
        return self._counters

    # --- What a person does -------------------------------------------------------------

    def open(self, settings: ConnectionSettings, *, may_move: bool) -> None:
        """Open a line and read everything; one that is open is closed first.

        `may_move` says that motors may be turning from an earlier one.
        """
        if self._line.is_open:
            self.close()
            self._next = settings
            return
        self._settings = settings
        self._counters = Counters()
        self._stand(
            ConnectionState.CONNECTING, self.tr("Connecting to {0} …").format(settings.text())
        )
        self._line.open(settings, may_move=may_move)

    def close(self) -> None:
        """Stop the motors if they were driven, and close the line; does not wait for it."""
        self._next = None
        if self._line.is_open and self._link is not ConnectionState.DISCONNECTING:
            self.closing.emit()
            self._line.close()
            self._stand(ConnectionState.DISCONNECTING, self.tr("Disconnecting …"))

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop every motor, from any thread; see `Line.stop_now`."""
        self._line.stop_now(ending=ending)

    def shut_down(self) -> bool:
        """Close the line and wait for it; return whether it ended in time. See `Line.shut_down`."""
        self._next = None
        was_open = self._line.is_open
        in_time = self._line.shut_down()
        if was_open:
            self.left.emit(self._line.last)
            self._stand(ConnectionState.DISCONNECTED, self.tr("Not connected."))
        return in_time

    def submit(self, request: Request) -> bool:
        """Hand a request to the session; return whether there is one."""
        return self._line.submit(request)

    def ask(
        self, make: Callable[[int], Reload | Stop | Write], then: Callable[[Outcome], None]
    ) -> bool:
        """Hand over a request that has an outcome; see `Line.ask`."""
        return self._line.ask(make, then)

    def note_stored(self, parameters: Mapping[str, int]) -> None:
        """Follow the board to the number that it stores now: it obeys a new one at once.

        The line session has done so.
        """
        if self._settings is not None and self._settings.device_number is not None:
            number = parameters.get(ParameterKey.DEVICE_NUMBER, self._settings.device_number)
            self._settings = replace(self._settings, device_number=number)

    # --- Reports from the line ----------------------------------------------------------

    @Slot(object)
    def _on_reported(self, report: Report) -> None:
        match report:
            case Batch():
                self._counters = report.counters
                self.sampled.emit(report)
            case MotorsStopped():
                self.halted.emit(report)
            case Progress(done=done, total=total, what=what):
                self.progressed.emit(done, total, what)
            case Connected() | NotResponding() if self._link is ConnectionState.DISCONNECTING:
                pass  # it was on its way when the line was given up
            case Connected():
                self._take(report)
            case NotResponding(reason=reason, counters=counters):
                self._counters = counters
                self._fall_silent(reason)

    def _take(self, report: Connected) -> None:
        self._settings = report.settings
        self._echo = report.echo
        self._port_rates = report.port_rates
        self.traffic.note_settings(report.settings, echo=report.echo)
        if self._wording.board != report.state.signature:
            self._wording.board = report.state.signature
            self.traffic.forget_words()
        self.answered.emit(report)
        self._stand(
            ConnectionState.CONNECTED, self.tr("Connected to {0}.").format(report.state.signature)
        )
        self.settled.emit()

    def _fall_silent(self, reason: str) -> None:
        self.silenced.emit()
        self._stand(
            ConnectionState.NOT_RESPONDING,
            self.tr("The board has stopped answering. Is its power on? Waiting for it …"),
        )
        log.info("the board fell silent: %s", reason)

    @Slot(object)
    def _on_closed(self, last: Closed) -> None:
        following, self._next = self._next, None
        self.left.emit(last)
        if following is not None:
            self.open(following, may_move=last.may_move)
            return
        self._stand(ConnectionState.DISCONNECTED, self.tr("Not connected."))
        if last.error is not None:
            self.failed.emit(str(last.error))

    def _stand(self, link: ConnectionState, status: str) -> None:
        self._link = link
        self._status = status
        self.changed.emit()
