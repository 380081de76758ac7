"""Session loop of a line, without Qt. It runs one transaction at a time.

Stops have the highest priority, followed by setpoints, requests and polls. No motor command except
a stop is sent without a request.
"""

import logging
from collections.abc import Callable
from dataclasses import dataclass, field

from trex_gui.core.discovery.prober import ScanProgress
from trex_gui.core.errors import BadReply, NoReply, PortUnavailable, StudioError
from trex_gui.core.guardian.guardian import HEARTBEAT_INTERVAL, StopSequence, joined_stops
from trex_gui.core.session import SHORTEST_WAIT, Closed, Inbox, Outcome, run_until_closed
from trex_gui.core.timing import FRAME, UNWATCHED_INTERVAL
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import other_board
from trex_gui.devices.trex.client.telemetry import StatusReader
from trex_gui.devices.trex.diagnosis import diagnose, explain
from trex_gui.devices.trex.driving.motor_driver import MotorDriver, stop_together
from trex_gui.devices.trex.driving.motor_output import MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    TrexError,
    TrexInternalError,
    TrexNoReplyError,
)
from trex_gui.devices.trex.protocol.line_settings import baud_rates
from trex_gui.devices.trex.session.board_reader import BoardReader
from trex_gui.devices.trex.session.jobs import JobServer
from trex_gui.devices.trex.session.messages import (
    BoardReport,
    OfBoard,
    ProbeProgress,
    ReadReason,
    Report,
    Request,
)
from trex_gui.devices.trex.session.open_line import OpenLine, SampleBatcher
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor
from trex_gui.devices.trex.session.request_queue import BoardQueue, TrexRequestQueue

log = logging.getLogger(__name__)


@dataclass(slots=True, eq=False)
class _Board:
    number: int | None  # device number in a group; `None` without a group
    settings: ConnectionSettings
    motors: MotorOutput
    liveness: LivenessMonitor
    queue: BoardQueue
    emit: Callable[[BoardReport], None]
    # Created when the line is opened:
    line: OpenLine = field(init=False)
    reader: BoardReader = field(init=False)
    jobs: JobServer = field(init=False)
    had_job: bool = False  # True if a request was served since the last poll
    stopped_another: bool = False  # True if another board confirmed the last stop


class TrexSession:
    """Session of a line, for one board or a group.

    Args:
        settings: connection settings of the board or group.
        inbox: requests to the session.
        emit: receives every report, in the thread of `run`.
        open_transport: opens the port.
        may_move: True if motors may still be moving from an earlier session. The session then
            sends a stop first.
    """

    def __init__(
        self,
        settings: ConnectionSettings,
        inbox: Inbox[Request],
        emit: Callable[[Report], None],
        open_transport: Callable[[ConnectionSettings], Transport] = SerialTransport,
        *,
        may_move: bool = False,
    ) -> None:
        self._settings = settings
        self._emit = emit
        self._open_transport = open_transport
        self._is_open = False
        self._boards = [
            self._create_board(number, settings.of_board(number), may_move)
            for number in settings.group
        ] or [self._create_board(None, settings, may_move)]
        self._has_driven = False  # True if the last step drove a board of a group
        self._in_turn = list(self._boards)  # least recently served board first
        queues = {board.number: board.queue for board in self._boards}
        self._requests = TrexRequestQueue(inbox, queues, is_ready=len(self._boards) == 1)

    def _create_board(
        self, number: int | None, settings: ConnectionSettings, may_move: bool
    ) -> _Board:
        def emit(report: BoardReport) -> None:
            if number is None:
                self._emit(report)
            elif isinstance(report, Outcome) and self._requests.is_for_all(report):
                if (outcome := self._requests.add_outcome(report, number)) is not None:
                    self._emit(outcome)
            else:
                self._emit(report if number == self._settings.group[0] else OfBoard(number, report))

        motors = MotorOutput(emit, settings.timeouts, may_move=may_move)
        if number is not None:  # a group is armed only after all its boards are read
            motors.handle(OutputEvent.STOP, 0.0)
        liveness = LivenessMonitor(settings.timeouts)
        queue = BoardQueue(motors, liveness, emit, self._now)
        return _Board(number, settings, motors, liveness, queue, emit)

    def run(self) -> None:
        """Serve the line until it is lost or closed, then report `Closed`.

        Never raises. Driven motors are always stopped, the port is closed, and every request has an
        outcome.
        """
        error = run_until_closed(
            self._open, self._step, lambda detail: TrexInternalError(ErrorCode.INTERNAL, detail)
        )
        if self._is_open:
            self._close_safely()
        self._requests.collect()
        reason = error or TrexError(ErrorCode.CLOSED)
        for number in self._requests.abandon():
            self._emit(Outcome(number, error=reason))
        may_move = any(board.motors.may_move or board.stopped_another for board in self._boards)
        self._emit(Closed(error, may_move))

    def _now(self) -> float:
        return self._transport.clock() if self._is_open else 0.0

    # --- Opening and closing ------------------------------------------------------------

    def _open(self) -> None:
        _ = self._settings.framing  # raises for impossible settings before the port is opened
        transport = GuardedTransport(
            self._open_transport(self._settings),
            self._settings.timeouts.guardian,
            self._stop_sequence,
            taken_over=self._on_taken_over,
            stop_is_due=self._is_stop_due,
        )
        self._transport = transport
        client = TrexClient(transport, self._boards[0].settings)
        lines: list[OpenLine] = []
        for board in self._boards:
            self._add(board, client, lines)
        self._is_open = True
        self._boards[0].reader.port_rates = transport.rates(baud_rates())
        try:
            try:
                self._start(client)
            except BadReply:
                # A line may lose the echo just after it is opened.
                self._start(client)
        except (NoReply, BadReply) as error:
            if self._needs_stop():  # a diagnosis would delay the stop
                raise explain(self._settings, echo=client.echo, error=error) from error
            raise diagnose(
                client, error, progress=self._report_probe, cancelled=self._needs_stop
            ) from error
        for board in self._boards[1:]:
            self._start_other(board, client)
        self._requests.is_ready = True
        drivers = [board.line.driver for board in self._boards]
        transport.while_waiting = lambda waited: min(
            driver.refresh_while_waiting(waited) for driver in drivers
        )

    def _add(self, board: _Board, client: TrexClient, lines: list[OpenLine]) -> None:
        board_client = client if board is self._boards[0] else client.to_board(board.settings)
        status, batcher = StatusReader(self._transport.clock), SampleBatcher(board.emit)
        sees_close = self._requests.sees_close
        board.line = OpenLine(
            client=board_client,
            transport=self._transport,
            motors=board.motors,
            driver=MotorDriver(board.motors, board_client, status, batcher.extend, sees_close),
            status=status,
            liveness=board.liveness,
            requests=self._requests,
            queue=board.queue,
            batcher=batcher,
            emit=board.emit,
            boards=lines,
            reserved=self._settings.reserved,
            has_driven=board.motors.may_move,
        )
        lines.append(board.line)
        board.reader = BoardReader(board.line)
        board.jobs = JobServer(board.line, board.reader)

    def _needs_stop(self) -> bool:
        self._boards[0].line.collect()
        return any(board.motors.may_move or board.motors.stops for board in self._boards)

    def _report_probe(self, step: ScanProgress) -> None:
        self._emit(ProbeProgress(step.done, step.total, step.line.text()))

    def _start(self, client: TrexClient) -> None:
        client.detect_echo(self._stop_early)
        first = self._boards[0]
        first.line.stop_if_moving()
        first.reader.read_everything(ReadReason.OPENED)

    def _start_other(self, board: _Board, client: TrexClient) -> None:
        board.line.client.echo = client.echo
        try:
            board.line.stop_if_moving()
            board.reader.read_everything(ReadReason.OPENED)
        except (NoReply, BadReply) as error:
            raise TrexNoReplyError(ErrorCode.OF_BOARD, board.number, error) from error

    def _stop_sequence(self) -> StopSequence | None:
        boards = self._boards
        if not self._is_open or not any(
            board.motors.may_move or board.motors.is_armed for board in boards
        ):
            return None
        names = " + ".join(str(board.reader.signature or "TReX") for board in boards)
        return joined_stops([board.line.client.stop_sequence(names) for board in boards])

    def _on_taken_over(self, confirmed: bool | None) -> None:
        """Drop all setpoints. The next step stops the motors again."""
        code = ErrorCode.NO_GUARDIAN if confirmed is None else ErrorCode.NO_HEARTBEAT
        for board in self._boards:
            board.motors.quality.is_shared = True
            board.motors.handle(OutputEvent.STOP, self._now())
            board.emit(MotorsStopped(code, bool(confirmed)))

    def _is_stop_due(self) -> bool:
        self._requests.collect()
        now = self._now()
        return any(
            board.motors.stops or board.motors.seconds_to_heartbeat_timeout(now) <= 0
            for board in self._boards
        )

    def _stop_early(self) -> None:
        self._requests.collect()
        for board in self._boards:
            board.line.driver.stop_early()

    def _close_safely(self) -> None:
        """Stop driven motors and close the port, even if the line fails."""
        boards, transport = self._boards, self._transport
        try:
            driven = [board for board in boards if board.motors.may_move]
            to_stop = [board for board in boards if board.motors.may_move or board.motors.stops]
            stop_together([board.line.driver.closing_stop() for board in to_stop])
            for board in driven:
                if not board.motors.may_move:
                    board.stopped_another = self._is_another(board)
            boards[0].line.client.drain()
            self._is_open = any(board.motors.may_move for board in boards)
            transport.beat()  # updates the guardian's stop sequence
        except StudioError:
            log.info("the line was closed without a confirmed stop", exc_info=True)
        except Exception:
            log.exception("closing the line failed")
        moving = [board for board in boards if board.motors.may_move]
        if moving and transport.stop_by_guardian():
            for board in moving:
                board.motors.handle(OutputEvent.STOP_CONFIRMED, self._now())
        try:
            for board in boards:
                board.line.flush()
        except Exception:  # the port must be closed even if the receiver failed
            log.exception("the last samples could not be reported")
        boards[0].line.client.close()

    def _is_another(self, board: _Board) -> bool:
        signature = board.reader.signature
        try:
            return signature is not None and (
                other_board(board.line.client.request, signature) is not None
            )
        except (NoReply, BadReply, PortUnavailable):
            return False

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        first = self._boards[0].line
        self._transport.beat()
        first.report_guardian()
        first.collect()
        now = first.now()
        in_use = any(
            board.motors.is_armed or board.motors.may_move or board.motors.is_repeating
            for board in self._boards
        )
        watched = in_use or self._requests.is_watched
        for board in self._boards:
            board.reader.polling.set_watched(watched, now)
            board.line.batcher.interval = FRAME if watched else UNWATCHED_INTERVAL
            board.line.has_driven = board.line.has_driven or board.motors.may_move
            board.line.flush_if_due(now)
        if first.serve_stops():
            return
        is_group = len(self._boards) > 1
        failing = is_group and any(board.liveness.is_failing for board in self._boards)
        if not self._has_driven and not failing and first.drive_next():
            self._has_driven = is_group  # in a group, a due poll precedes the next setpoints
            return
        has_driven, self._has_driven = self._has_driven, False
        # A failing board comes first, because its silence stops the group.
        for board in sorted(self._in_turn, key=lambda board: not board.liveness.is_failing):
            if self._serve(board, now, watched=watched):
                self._in_turn.remove(board)
                self._in_turn.append(board)
                return
        if has_driven:
            return  # due setpoints come next
        first.collect(self._seconds_to_wait(now))

    def _serve(self, board: _Board, now: float, *, watched: bool) -> bool:
        reader, liveness, jobs = board.reader, board.liveness, board.queue.jobs
        if jobs and not board.had_job:
            self._serve_job(board)
        elif liveness.is_silent and now >= liveness.retry_at:
            reader.try_to_reconnect()
        elif not liveness.is_silent and now >= reader.safety_read_at and watched:
            reader.check_safety_parameter(now)
        elif not liveness.is_silent and (topic := reader.next_topic(now)):
            reader.poll(topic)
            board.had_job = False
        elif jobs:
            self._serve_job(board)
        else:
            return False
        return True

    def _serve_job(self, board: _Board) -> None:
        """Serve a request. A due poll precedes the next request."""
        board.had_job = True
        board.jobs.serve(board.queue.jobs.popleft())

    def _seconds_to_wait(self, now: float) -> float:
        seconds = HEARTBEAT_INTERVAL
        for board in self._boards:
            line, liveness, reader = board.line, board.liveness, board.reader
            due = liveness.retry_at - now if liveness.is_silent else reader.seconds_to_next(now)
            driving, batch = line.driver.seconds_to_next(), line.batcher.seconds_to_next(now)
            seconds = min(seconds, due, driving, batch)
        return max(SHORTEST_WAIT, seconds)
