"""Session of an open line, for programs that drive boards."""

import logging
from collections import deque
from collections.abc import Callable, Iterator
from itertools import count
from typing import Any

from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable, StudioError, describe
from trex_gui.core.events import Event
from trex_gui.core.host import host
from trex_gui.core.session import Close, Closed, Outcome, RequestQueue
from trex_gui.core.transport.adapters import adapter_key
from trex_gui.devices.trex.board.drive_status import DriveInputs
from trex_gui.devices.trex.board.keeper import Keeper
from trex_gui.devices.trex.board.mirror import BoardMirror, DriveLost
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import LatchedStatus, Sample
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.driving.requests import (
    HEARTBEAT_INTERVAL,
    Arm,
    Heartbeat,
    MotorsStopped,
    Stop,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import STOP_UNCONFIRMED
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.serve.sessions import session_at
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    LeaseChanged,
    NotResponding,
    OfBoard,
    ReadReason,
    Report,
    ToBoard,
)
from trex_gui.devices.trex.settings.board_records import utc_now

log = logging.getLogger(__name__)

NOT_OPEN = "The line is not open: use a Trex inside its `with` block."
_LATE = (
    "The program did not call the board's methods for more than half a second while motors were "
    "driven."
)
_STOP_TIMEOUT = 10.0  # maximum seconds until a stop is confirmed
_STOPPED = "The motors were stopped."
_MAX_QUEUED = 1000  # unread reports of a line, and unread events of a board


class MotorsStoppedError(StudioError):
    """The motors stopped, although the program did not call `stop`."""


class OpenSession:
    """Session of a line that one thread of a program uses."""

    def __init__(self, settings: ConnectionSettings) -> None:
        computer = host()
        self.clock = computer.clock
        self.is_armed = False
        self.closed: Closed | None = None
        self._group = settings.group
        numbers: tuple[int | None, ...] = settings.group or (None,)
        self.boards = {number: OpenBoard(self, number, settings) for number in numbers}
        self._ids = count(1)
        self._outcomes: dict[int, Outcome] = {}
        self._inbox = RequestQueue(computer.condition())
        self.put = self._inbox.put
        self._reports = RequestQueue(computer.condition())
        session = session_at(
            settings, self._inbox, self._put_report, computer.open_transport, computer.clock
        )
        self._join = computer.start_thread(session.run)

    def _put_report(self, report: Report) -> None:
        """Queue a report. If the queue is full, drop all samples except status bits."""
        batch = report.report if isinstance(report, OfBoard) else report
        if isinstance(batch, Batch) and len(self._reports) >= _MAX_QUEUED:
            latched = tuple(s for s in batch.samples if isinstance(s, LatchedStatus))
            if not latched:
                return
            batch = Batch(latched, batch.counters)
            report = OfBoard(report.number, batch) if isinstance(report, OfBoard) else batch
        self._reports.put(report)

    def require_open(self) -> None:
        if self.closed is not None:
            raise self.closed.error or PortUnavailable(NOT_OPEN)

    def open(self) -> None:
        try:
            self.wait_for(lambda: all(board.mirror.state for board in self.boards.values()))
        except BaseException:
            self.close()
            raise

    def result(self, request: Callable[[int], object], seconds: float) -> object:
        """Send `request(id)`. Return the value of its outcome, or raise its error."""
        request_id = next(self._ids)
        self.require_open()
        self.put(request(request_id))
        self.wait_for(lambda: request_id in self._outcomes, seconds)
        outcome = self._outcomes.pop(request_id)
        if outcome.error is not None:
            raise outcome.error
        return outcome.value

    @property
    def lease(self) -> LeaseChanged | None:
        """Lease of a served line. `None` for a local line."""
        return next(iter(self.boards.values())).mirror.lease

    @property
    def has_lease(self) -> bool:
        """True if this program holds the lease, or needs no lease."""
        return self.lease is None or self.lease.is_mine

    def require_drivable(self) -> None:
        """Raise NoReply if a board is silent, or BadRequest if it ignores serial commands."""
        for board in self.boards.values():
            if not board.mirror.is_responding:
                raise NoReply(board.named(Reason(DriveBlocker.SILENT).text()))
            if not board.mirror.serial_controls:
                raise BadRequest(board.named(board.mirror.control_text))

    def arm(self) -> None:
        if not self.is_armed:
            self.is_armed = True
            self.put(Arm())

    def stop(self) -> None:
        self.is_armed = False
        self.result(Stop, _STOP_TIMEOUT)
        for board in self.boards.values():
            board.driven.clear()

    def wait_for(self, condition: Callable[[], bool], seconds: float = 60.0) -> None:
        end = self.clock() + seconds
        while not condition():
            if self.clock() >= end:
                raise NoReply(f"The board did not reply within {seconds:g} s.")
            self.pump(end)

    def pump(self, end: float) -> list[tuple["OpenBoard", Sample]]:
        """Wait for a report, then handle all queued reports.

        Returns each sample with its board. Sends a heartbeat if the motors are armed. Waits until
        `end` (on the session's clock), but no longer than `HEARTBEAT_INTERVAL`.
        """
        if self.is_armed:
            self.put(Heartbeat())
        samples: list[tuple[OpenBoard, Sample]] = []
        seconds = min(max(end - self.clock(), 0.0), HEARTBEAT_INTERVAL)
        report = self._reports.get(seconds)
        while report is not None:
            boards = list(self.boards.values())
            if isinstance(report, OfBoard):
                of_board, report = self.boards.get(report.number), report.report
                boards = [] if of_board is None else [of_board]
            elif not isinstance(report, Closed):
                del boards[1:]  # reports of the first board have no number
            for board in boards:
                samples += ((board, sample) for sample in board.handle(report))
            self._handle(report)
            report = self._reports.get(0.0)
        return samples

    def _handle(self, report: Report) -> None:
        match report:
            case Connected(settings=settings) if self._group not in {(), settings.group}:
                served = ", ".join(map(str, settings.group)) or str(settings.device_number)
                raise BadRequest(f"The server of this line drives these boards: {served}.")
            case Outcome(id=number):
                self._outcomes[number] = report
            case Closed():
                self.closed, self.is_armed = report, False
                self.require_open()

    def close(self) -> Closed | None:
        self.is_armed = False
        self.put(Close())
        self._join()
        while self.closed is None and (report := self._reports.get(0.0)) is not None:
            if isinstance(report, Closed):
                self.closed = report
        return self.closed

    def end(self, error: BaseException | None) -> None:
        """Close the line. If a stop is unconfirmed, raise NoReply or add a note to `error`."""
        closed = self.close()
        if closed is not None and closed.may_move:
            if error is None:
                raise NoReply(STOP_UNCONFIRMED)
            error.add_note(STOP_UNCONFIRMED)


class OpenBoard:
    """Board of a session, with its errors and events."""

    def __init__(
        self, session: OpenSession, number: int | None, settings: ConnectionSettings
    ) -> None:
        self.session = session
        self.keeper = Keeper(log.info, log.warning)
        self.mirror = BoardMirror(self.keeper.memory)
        self.mirror.adapter = adapter_key(settings.url)
        self.driven: dict[int, int] = {}  # motor → last speed sent since the last confirmed stop
        self.errors: dict[str, None] = {}  # names of the error bits since the last `Trex.status`
        self.events = deque[Event](maxlen=_MAX_QUEUED)  # events since the program last read them
        self._number = number  # device number in a group; `None` for a single board

    @property
    def state(self) -> DeviceState:
        assert self.mirror.state is not None  # noqa: S101 - `OpenSession.open` waits for it
        return self.mirror.state

    def addressed(self, request: Any) -> Any:
        return request if self._number is None else ToBoard(self._number, request)

    def pump(self, end: float) -> list[Sample]:
        """Return the samples of this board. See `OpenSession.pump`."""
        return [sample for board, sample in self.session.pump(end) if board is self]

    def handle(self, report: Report) -> Iterator[Sample]:
        """Handle a report and yield its samples.

        Raises:
            NoReply: the board has stopped responding.
            MotorsStoppedError: the motors were stopped.
        """
        for event in self.mirror.handle(report, self.session.clock(), utc_now()):
            match event:
                case LatchedStatus():
                    self._handle_status(event)
                    yield event
                case Sample():
                    yield event
                case DriveLost(reason=reason):
                    self._stop_all(reason)
                case Event():
                    self.events.append(event)
        match report:
            case Connected(may_move=False) | MotorsStopped(confirmed=True):
                self.driven.clear()
        match report:
            case Connected(occasion=occasion, may_move=may_move) if (
                self.session.is_armed and occasion is not ReadReason.RELOADED
            ):
                end = STOP_UNCONFIRMED if may_move else _STOPPED
                self._fail(f"The board was restarted, or a setting was changed. {end}")
            case NotResponding(reason=reason):
                self.session.is_armed = False
                raise NoReply(self.named(f"The board has stopped responding: {reason}"))
            case MotorsStopped(reason=code, confirmed=confirmed, board=number) if code is not None:
                cause = _LATE if code is ErrorCode.NO_HEARTBEAT else describe(code, (number,))
                end = _STOPPED if confirmed else STOP_UNCONFIRMED
                self._fail(f"{cause} {end}", is_named=number is not None)

    def _handle_status(self, latched: LatchedStatus) -> None:
        self.errors |= dict.fromkeys(latched.names)
        stops_on_error = self.state.stops_on_error
        if not latched.is_earlier and latched.stops_motors(on_error=stops_on_error):
            self._stop_all(f"The board reports: {', '.join(latched.names)}.")

    def _stop_all(self, reason: str) -> None:
        """If armed, stop every board and raise MotorsStoppedError."""
        if self.session.is_armed:
            self.session.stop()
            self._fail(f"{reason} {_STOPPED}")

    def _fail(self, text: str, *, is_named: bool = False) -> None:
        """Raise MotorsStoppedError. `is_named`: True if the text already names the board."""
        self.session.is_armed = False
        raise MotorsStoppedError(text if is_named else self.named(text))

    def named(self, text: str) -> str:
        return text if self._number is None else f"Board {self._number}: {text}"

    def drive_inputs(self) -> DriveInputs:
        return DriveInputs(
            board=self.mirror.inputs(self.session.clock()),
            link=None if self.mirror.is_responding else self.mirror.silence,
            may_move=bool(self.driven),
            driven=frozenset(self.driven),
            silence_remedy=self.mirror.silence_remedy,
            other_driver=self.mirror.other_driver,
            other_speeds=self.mirror.other_speeds,
            armed=self.session.is_armed,
        )
