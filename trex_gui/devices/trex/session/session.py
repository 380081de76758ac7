"""The loop that owns a line: it takes requests, runs one transaction at a time and reports.

It knows neither threads nor Qt. Order of service: stop, drive, requests, polling. A stop is the
one motor command that is sent unprompted.
"""

import logging
from collections.abc import Callable

from trex_gui.core.discovery.prober import ScanProgress
from trex_gui.core.errors import BadReply, NoReply, PortUnavailable, StudioError
from trex_gui.core.guardian.guardian import HEARTBEAT_INTERVAL, StopSequence
from trex_gui.core.session import SHORTEST_WAIT, Closed, Inbox, Outcome, run_until_closed
from trex_gui.core.timing import FRAME, UNWATCHED_INTERVAL
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import other_board
from trex_gui.devices.trex.client.telemetry import StatusReader
from trex_gui.devices.trex.diagnosis import diagnose, explain
from trex_gui.devices.trex.driving.motor_driver import MotorDriver
from trex_gui.devices.trex.driving.motor_output import MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError, TrexInternalError
from trex_gui.devices.trex.protocol.line_settings import baud_rates
from trex_gui.devices.trex.session.board_reader import BoardReader
from trex_gui.devices.trex.session.jobs import JobServer
from trex_gui.devices.trex.session.messages import ProbeProgress, ReadReason, Report, Request
from trex_gui.devices.trex.session.open_line import OpenLine, SampleBatcher
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor
from trex_gui.devices.trex.session.request_queue import TrexRequestQueue

log = logging.getLogger(__name__)


class TrexSession:
    """Serves one line from opening it to closing it.

    Args:
        settings: how to reach the board.
        inbox: where requests come from.
        emit: receives every report, in the thread of `run`.
        open_transport: opens the port.
        may_move: motors may be moving since an earlier session: a stop is sent before anything
            else.
    """

    # Since the line was opened:
    _line: OpenLine
    _reader: BoardReader
    _jobs: JobServer

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
        self._motors = MotorOutput(emit, settings.timeouts, may_move=may_move)
        self._liveness = LivenessMonitor(settings.timeouts)
        self._queue = TrexRequestQueue(inbox, self._motors, self._liveness, emit, self._now)
        self._had_job = False  # since the last poll
        self._stopped_another = False  # at the end another board than the one driven answered

    def run(self) -> None:
        """Serve the line until it is lost or `Close` comes; then report `Closed`.

        Never raises: whatever happens, motors that were driven are stopped, the port is closed and
        every request gets its outcome.
        """
        error = run_until_closed(
            self._open, self._step, lambda detail: TrexInternalError(ErrorCode.INTERNAL, detail)
        )
        if self._is_open:
            self._leave_safely()
        self._queue.collect()
        reason = error or TrexError(ErrorCode.CLOSED)
        for number in self._queue.abandon():
            self._emit(Outcome(number, error=reason))
        self._emit(Closed(error, self._motors.may_move or self._stopped_another))

    def _now(self) -> float:
        return self._line.now() if self._is_open else 0.0

    # --- Beginning and end --------------------------------------------------------------

    def _open(self) -> None:
        _ = self._settings.framing  # impossible settings must not open the port
        transport = GuardedTransport(
            self._open_transport(self._settings),
            self._settings.timeouts.guardian,
            self._stop_sequence,
            taken_over=self._on_taken_over,
            stop_is_due=self._is_stop_due,
        )
        client = TrexClient(transport, self._settings)
        status, batcher = StatusReader(transport.clock), SampleBatcher(self._emit)
        driver = MotorDriver(self._motors, client, status, batcher.extend, self._queue.sees_close)
        self._line = OpenLine(
            client=client,
            transport=transport,
            motors=self._motors,
            driver=driver,
            status=status,
            liveness=self._liveness,
            queue=self._queue,
            batcher=batcher,
            emit=self._emit,
            has_driven=self._motors.may_move,
        )
        self._reader = BoardReader(self._line)
        self._jobs = JobServer(self._line, self._reader)
        self._is_open = True
        self._reader.port_rates = transport.rates(baud_rates())
        try:
            try:
                self._begin(client)
            except BadReply:
                # A line that was just opened may have swallowed the echo that was waited for.
                self._begin(client)
        except (NoReply, BadReply) as error:
            raise self._why_not_found(client, error) from error
        transport.while_waiting = driver.refresh_while_waiting

    def _why_not_found(self, client: TrexClient, error: StudioError) -> StudioError:
        """Probe for what is there instead, unless motors have to be stopped first."""
        if self._is_stop_wanted():
            return explain(self._settings, echo=client.echo, error=error)
        return diagnose(client, error, progress=self._report_probe, cancelled=self._is_stop_wanted)

    def _is_stop_wanted(self) -> bool:
        self._line.collect()
        return self._motors.may_move or bool(self._motors.stops)

    def _report_probe(self, step: ScanProgress) -> None:
        self._emit(ProbeProgress(step.done, step.total, step.line.text()))

    def _begin(self, client: TrexClient) -> None:
        client.detect_echo(self._stop_early)
        self._line.stop_if_moving()
        self._reader.read_everything(ReadReason.OPENED)

    def _stop_sequence(self) -> StopSequence | None:
        if not self._is_open or not (self._motors.may_move or self._motors.is_armed):
            return None
        return self._line.client.stop_sequence(str(self._reader.signature or "TReX"))

    def _on_taken_over(self, confirmed: bool | None) -> None:
        """Drop the setpoints; the motors are stopped again before the line is used for more."""
        self._motors.quality.is_shared = True
        self._motors.handle(OutputEvent.STOP, self._now())
        code = ErrorCode.NO_GUARDIAN if confirmed is None else ErrorCode.NO_HEARTBEAT
        self._emit(MotorsStopped(code, bool(confirmed)))

    def _is_stop_due(self) -> bool:
        self._queue.collect()
        return (
            bool(self._motors.stops) or self._motors.seconds_to_heartbeat_timeout(self._now()) <= 0
        )

    def _stop_early(self) -> None:
        self._queue.collect()
        self._line.driver.stop_early()

    def _leave_safely(self) -> None:
        """Stop motors that were driven and close the port, whatever the line does."""
        line, client = self._line, self._line.client
        try:
            was_driven = self._motors.may_move
            if was_driven or self._motors.stops:
                line.driver.stop_on_close()
            if was_driven and not self._motors.may_move:
                self._stopped_another = self._is_another_board()
            client.drain()
            self._is_open = self._motors.may_move
            line.transport.beat()  # a guardian that is not told so keeps the board as left running
        except StudioError:
            log.info("the line was closed without a confirmed stop", exc_info=True)
        except Exception:
            log.exception("leaving the line failed")
        if self._motors.may_move and line.transport.stop_by_guardian():
            self._motors.handle(OutputEvent.STOP_CONFIRMED, self._now())
        try:
            line.flush()
        except Exception:  # the receiver may be what failed; the port is closed all the same
            log.exception("the last samples could not be reported")
        client.close()

    def _is_another_board(self) -> bool:
        """Whether the board that replies now is known not to be the one that was read."""
        signature = self._reader.signature
        try:
            return signature is not None and (
                other_board(self._line.client.request, signature) is not None
            )
        except (NoReply, BadReply, PortUnavailable):
            return False

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        line, reader = self._line, self._reader
        line.transport.beat()
        line.report_guardian()
        line.collect()
        now = line.now()
        motors = self._motors
        in_use = motors.is_armed or motors.may_move or motors.is_repeating
        watched = in_use or self._queue.is_watched
        reader.polling.set_watched(watched, now)
        line.batcher.interval = FRAME if watched else UNWATCHED_INTERVAL
        line.has_driven = line.has_driven or motors.may_move
        line.flush_if_due(now)
        if line.serve_motors():
            return
        if self._queue.jobs and not self._had_job:
            self._serve_job()
        elif self._liveness.silent and now >= self._liveness.retry_at:
            reader.try_to_reconnect()
        elif not self._liveness.silent and now >= reader.safety_read_at and watched:
            reader.check_safety_parameter(now)
        elif not self._liveness.silent and (topic := reader.next_topic(now)):
            reader.poll(topic)
            self._had_job = False
        elif self._queue.jobs:
            self._serve_job()
        else:
            line.collect(self._seconds_to_wait(now))

    def _serve_job(self) -> None:
        """Serve a request; a poll that is due has its turn before the next one."""
        self._had_job = True
        self._jobs.serve(self._queue.jobs.popleft())

    def _seconds_to_wait(self, now: float) -> float:
        line = self._line
        if self._liveness.silent:
            seconds = self._liveness.retry_at - now
        else:
            seconds = self._reader.seconds_to_next(now)
        driving, batch = line.driver.seconds_to_next(), line.batcher.seconds_to_next(now)
        return max(SHORTEST_WAIT, min(seconds, driving, batch, HEARTBEAT_INTERVAL))
