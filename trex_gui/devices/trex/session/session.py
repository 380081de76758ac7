"""The loop that owns a line: it takes requests, runs one transaction at a time and reports.

It knows neither threads nor Qt. Order of service: stop, drive, requests, polling. A stop is the
one motor command that is sent unprompted.
"""

import itertools
import logging
import math
from collections.abc import Callable
from dataclasses import replace

from trex_gui.core.discovery.prober import ScanProgress
from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable, StudioError
from trex_gui.core.guardian.guardian import HEARTBEAT_INTERVAL, StopSequence
from trex_gui.core.session import (
    SHORTEST_WAIT,
    Closed,
    Closing,
    Inbox,
    Outcome,
    Progress,
    run_until_closed,
)
from trex_gui.core.timing import FRAME, UNWATCHED_INTERVAL
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.devices.trex.client.client import Requester, TrexClient
from trex_gui.devices.trex.client.reading import (
    ATTEMPTS,
    DeviceState,
    agreed,
    board_at,
    is_several,
    other_board,
    read_everything,
    require_free_number,
)
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus, ModeSample, StatusReader
from trex_gui.devices.trex.client.writing import WriteResult, after_writing, write_all
from trex_gui.devices.trex.diagnosis import diagnose, explain
from trex_gui.devices.trex.driving.motor_driver import MotorDriver
from trex_gui.devices.trex.driving.motor_output import MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetMode,
    GetParameter,
    ReplyT_co,
    Signature,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    OtherBoard,
    Rejected,
    TrexBadReplyError,
    TrexError,
    TrexInternalError,
    TrexNoReplyError,
    TrexRequestError,
)
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.protocol.line_settings import baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.session.messages import (
    Connected,
    GuardianChanged,
    Job,
    NotResponding,
    ProbeNumber,
    ProbeProgress,
    ReadReason,
    Reload,
    Report,
    Request,
    RunCommand,
    SelectBoard,
    SendPacket,
    Write,
    Written,
)
from trex_gui.devices.trex.session.polling import (
    SAFETY_PARAMETERS,
    Polling,
    SampleBatcher,
    Topic,
    poll,
)
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor, reconnect_candidates
from trex_gui.devices.trex.session.request_queue import TrexRequestQueue

log = logging.getLogger(__name__)

_STALE_READS = 3
_STALE_READ_INTERVAL = 2.0  # seconds; telemetry goes on between two of these readings

_SAFETY_READ_INTERVAL = 0.25
"""Seconds between two queries of `SAFETY_PARAMETERS` in turn, so each is read every second. At
1200 baud they take a tenth of the line."""


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
    _state: DeviceState
    _transport: GuardedTransport

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
        self._client: TrexClient | None = None
        self._motors = MotorOutput(emit, settings.timeouts, may_move=may_move)
        self._liveness = LivenessMonitor(settings.timeouts)
        self._queue = TrexRequestQueue(inbox, self._motors, self._liveness, emit, self._now)
        self._batcher = SampleBatcher(emit)
        self._polling = Polling()
        # How often to read again what the board may store otherwise than `_state` says, and when:
        self._stale_reads = 0
        self._stale_read_at = -math.inf
        self._safety_keys = itertools.cycle(SAFETY_PARAMETERS)
        self._safety_read_at = -math.inf
        self._is_guarded = False
        self._port_rates: frozenset[int] | None = None
        self._signature: Signature | None = None  # of the board that was read last
        self._has_driven = may_move  # since no stop was sent to each board on the line
        self._stopped_another = False  # at the end another board than the one driven answered

    def run(self) -> None:
        """Serve the line until it is lost or `Close` comes; then report `Closed`.

        Never raises: whatever happens, motors that were driven are stopped, the port is closed and
        every request gets its outcome.
        """
        error = run_until_closed(
            self._open, self._step, lambda detail: TrexInternalError(ErrorCode.INTERNAL, detail)
        )
        if self._client is not None:
            self._leave_safely(self._client)
        self._queue.collect()
        reason = error or TrexError(ErrorCode.CLOSED)
        for number in self._queue.abandon():
            self._emit(Outcome(number, error=reason))
        self._emit(Closed(error, self._motors.may_move or self._stopped_another))

    def _now(self) -> float:
        return 0.0 if self._client is None else self._client.transport.clock()

    # --- Beginning and end --------------------------------------------------------------

    def _open(self) -> None:
        _ = self._settings.framing  # impossible settings must not open the port
        transport = self._transport = GuardedTransport(
            self._open_transport(self._settings),
            self._settings.timeouts.guardian,
            self._stop_sequence,
            taken_over=self._on_taken_over,
            stop_is_due=self._is_stop_due,
        )
        client = self._client = TrexClient(transport, self._settings)
        self._port_rates = transport.rates(baud_rates())
        self._status = StatusReader(transport.clock)
        self._driver = MotorDriver(
            self._motors, client, self._status, self._batcher.extend, self._is_closing
        )
        try:
            try:
                self._begin(client)
            except BadReply:
                # A line that was just opened may have swallowed the echo that was waited for.
                self._begin(client)
        except (NoReply, BadReply) as error:
            raise self._why_not_found(client, error) from error
        transport.while_waiting = self._driver.refresh_while_waiting

    def _why_not_found(self, client: TrexClient, error: StudioError) -> StudioError:
        """Probe for what is there instead, unless motors have to be stopped first."""
        if self._is_stop_wanted():
            return explain(self._settings, echo=client.echo, error=error)
        return diagnose(client, error, progress=self._report_probe, cancelled=self._is_stop_wanted)

    def _is_stop_wanted(self) -> bool:
        self._collect()
        return self._motors.may_move or bool(self._motors.stops)

    def _report_probe(self, step: ScanProgress) -> None:
        self._emit(ProbeProgress(step.done, step.total, step.line.text()))

    def _begin(self, client: TrexClient) -> None:
        client.detect_echo(self._stop_early)
        self._stop_if_moving()
        self._read_everything(ReadReason.OPENED)

    def _stop_sequence(self) -> StopSequence | None:
        moving = self._client is not None and (self._motors.may_move or self._motors.is_armed)
        return self._line.stop_sequence(str(self._signature or "TReX")) if moving else None

    def _on_taken_over(self, confirmed: bool | None) -> None:
        """Drop the setpoints; the motors are stopped again before the line is used for more."""
        self._motors.quality.is_shared = True
        self._motors.handle(OutputEvent.LOCK_OUT, self._now())
        code = ErrorCode.NO_GUARDIAN if confirmed is None else ErrorCode.NO_HEARTBEAT
        self._emit(MotorsStopped(code, bool(confirmed)))

    def _is_stop_due(self) -> bool:
        self._queue.collect()
        return (
            bool(self._motors.stops) or self._motors.seconds_to_heartbeat_timeout(self._now()) <= 0
        )

    def _report_guardian(self) -> None:
        if self._transport.is_guarded != self._is_guarded:
            self._is_guarded = not self._is_guarded
            self._emit(GuardianChanged(self._is_guarded))

    def _stop_early(self) -> None:
        self._queue.collect()
        self._driver.stop_early()

    def _stop_if_moving(self) -> None:
        if self._motors.may_move:
            self._driver.stop_and_confirm()

    def _is_closing(self) -> bool:
        self._queue.collect()
        return self._queue.is_closing

    def _leave_safely(self, client: TrexClient) -> None:
        """Stop motors that were driven and close the port, whatever the line does."""
        try:
            was_driven = self._motors.may_move
            if was_driven or self._motors.stops:
                self._driver.stop_on_close()
            if was_driven and not self._motors.may_move:
                self._stopped_another = self._is_another_board(client.request)
            client.drain()
        except StudioError:
            log.info("the line was closed without a confirmed stop", exc_info=True)
        except Exception:
            log.exception("leaving the line failed")
        if self._motors.may_move and self._transport.stop_by_guardian():
            self._motors.handle(OutputEvent.STOP_CONFIRMED, self._now())
        try:
            self._flush()
        except Exception:  # the receiver may be what failed; the port is closed all the same
            log.exception("the last samples could not be reported")
        client.close()

    def _is_another_board(self, request: Requester) -> bool:
        """Whether the board that replies now is known not to be the one that was read."""
        try:
            signature = self._signature
            return signature is not None and other_board(request, signature) is not None
        except (NoReply, BadReply, PortUnavailable):
            return False

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        self._transport.beat()
        self._report_guardian()
        self._collect()
        now = self._now()
        self._set_pace(now)
        self._has_driven = self._has_driven or self._motors.may_move
        if self._batcher.seconds_to_next(now) <= 0:
            self._flush()
        if self._serve_motors():
            return
        if self._queue.jobs:
            self._serve(self._queue.jobs.popleft())
        elif self._liveness.silent and now >= self._liveness.retry_at:
            self._try_to_reconnect()
        elif not self._liveness.silent and now >= self._safety_read_at and self._is_watched:
            self._check_safety_parameter(now)
        elif not self._liveness.silent and (topic := self._next_topic(now)):
            self._poll(topic)
        else:
            self._collect(self._seconds_to_wait(now))

    @property
    def _is_watched(self) -> bool:
        motors = self._motors
        return self._queue.is_watched or motors.is_armed or motors.may_move

    def _set_pace(self, now: float) -> None:
        watched = self._is_watched
        self._polling.set_watched(watched, now)
        self._batcher.interval = FRAME if watched else UNWATCHED_INTERVAL

    def _collect(self, seconds: float = 0.0) -> None:
        self._queue.collect(seconds)
        self._line.keepalive_while_waiting = self._motors.is_armed
        if self._queue.is_closing:
            raise Closing

    def _seconds_to_wait(self, now: float) -> float:
        if self._liveness.silent:
            seconds = self._liveness.retry_at - now
        else:
            armed = self._motors.is_armed
            seconds = self._polling.seconds_to_next(now, self._state.serial_timeout, armed=armed)
        driving, batch = self._driver.seconds_to_next(), self._batcher.seconds_to_next(now)
        return max(SHORTEST_WAIT, min(seconds, driving, batch, HEARTBEAT_INTERVAL))

    def _serve_motors(self) -> bool:
        """Stop or drive if that is due; return whether the line was used."""
        try:
            if self._motors.quality.is_shared:
                self._driver.stop_after_take_over()
                return True
            return self._driver.serve()
        except (NoReply, BadReply) as error:
            self._note_failure(error)
            return True

    def _request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Run one transaction of a longer operation, after whatever is more urgent."""
        self._collect()
        self._serve_motors()
        return self._line.request(command)

    @property
    def _line(self) -> TrexClient:
        assert self._client is not None  # noqa: S101 - only used once the line is open
        return self._client

    def _flush(self) -> None:
        self._batcher.flush(self._line.counters, self._now())

    def _report_progress(self, done: int, total: int, what: str) -> None:
        self._emit(Progress(done, total, what))

    # --- Requests -----------------------------------------------------------------------

    def _serve(self, job: Job) -> None:
        try:
            value = self._result_of(job)
        except (BadRequest, NoReply, BadReply, Rejected, OtherBoard) as error:
            self._emit(Outcome(job.id, error=error))
        except BaseException:
            # The session ends, and reports an outcome of every queued request.
            self._queue.jobs.appendleft(job)
            raise
        else:
            self._emit(Outcome(job.id, value))

    def _result_of(self, job: Job) -> object:
        if self._liveness.is_scanning(self._line):
            # Nothing may reach a board at unknown settings.
            raise TrexNoReplyError(ErrorCode.SCANNING)
        match job:
            case RunCommand(command=command) if command.moves:
                # At once: behind a stop that comes now it would start what was stopped.
                self._motors.check(command, self._now())
                return self._driver.run_direct(command)
            case RunCommand(command=command):
                return self._request(command)
            case SendPacket(packet=packet):
                return self._send_packet(packet)
            case Write():
                return self._write(job)
            case Reload():
                returned = ReadReason.RETURNED if self._liveness.silent else ReadReason.RELOADED
                self._read_everything(returned)
                return None
            case ProbeNumber(number=number, attempts=attempts):
                self._require_stopped()
                return board_at(self._line, number, attempts=attempts)
            case SelectBoard():
                self._select(job)
                return None

    def _require_stopped(self) -> None:
        if self._motors.is_armed or self._motors.may_move:
            raise TrexRequestError(ErrorCode.OTHERS_WHILE_DRIVING)

    def _select(self, job: SelectBoard) -> None:
        """Address another board once the motors of the present one are known to be stopped.

        What was requested for the present board reaches no other one: setpoints are dropped, and
        arming has no effect until everything is read, and then only for the new `selection`.
        """
        motors, client, before = self._motors, self._line, self._line.settings
        selection = self._queue.selection
        motors.handle(OutputEvent.LOCK_OUT, self._now())
        if motors.may_move:
            if not self._driver.stop_and_confirm():
                raise TrexNoReplyError(ErrorCode.NOT_SELECTED_MOVING, job.number)
            self._emit(MotorsStopped(None, confirmed=True))
        motors.handle(OutputEvent.NOT_RESPONDING, self._now())
        self._flush()
        try:
            if before.device_number is None and self._has_driven:
                self._stop_each(job)
            self._address(job)
        except BaseException:
            client.settings = before
            self._queue.selection = selection
            self._status.uart_due = True
            if not self._liveness.silent:
                motors.handle(OutputEvent.BOARD_READ, self._now())
            raise
        self._liveness.expect(())  # these were for the other board

    def _address(self, job: SelectBoard) -> None:
        client = self._line
        if board_at(client, job.number, attempts=ATTEMPTS) is None:
            raise TrexNoReplyError(ErrorCode.NOT_SELECTED_SILENT, job.number)
        client.settings = replace(client.settings, device_number=job.number)
        self._queue.selection = job.id
        self._status.begin()
        self._read_everything(ReadReason.SELECTED)

    def _stop_each(self, job: SelectBoard) -> None:
        """Stop every board on the line: commands without a number have reached all of them."""
        for number in job.sharing:
            self._line.settings = replace(self._line.settings, device_number=number)
            self._motors.handle(OutputEvent.DIRECT_COMMAND_SENT, self._now())
            if not self._driver.stop_and_confirm():
                raise TrexNoReplyError(ErrorCode.NOT_SELECTED_MOVING, job.number)
        self._has_driven = False

    def _send_packet(self, packet: RawPacket) -> bytes:
        """Send what the user typed; a packet that moves goes the way of a motor command."""
        if packet.moves:
            number = self._line.settings.device_number
            if not self._motors.is_armed:
                raise TrexRequestError(ErrorCode.NOT_ARMED)
            if not packet.is_within_stop(number):
                raise TrexRequestError(ErrorCode.MOVES_ANOTHER_BOARD, number)
            self._driver.begin_direct()
        else:
            self._collect()
            self._serve_motors()
        try:
            reply = self._line.send_packet(packet.packet)
        except (NoReply, BadReply):
            self._status.uart_due = True  # it may have cleared bits
            if packet.writes:
                self._stale_reads = _STALE_READS  # it may be stored all the same
            raise
        if packet.device_number in self._own_numbers:
            self._keep_cleared(reply.value)
        if packet.writes:
            self._read_after_write()
        return reply.raw

    def _read_after_write(self) -> None:
        """Read what a packet of the user's has stored, and where the board will be with it."""
        before = self._state.parameters
        self._read_everything(ReadReason.RELOADED)
        state = self._state
        places = reconnect_candidates(
            self._line.settings, before, state.parameters, state.signature.firmware
        )
        if places:
            self._liveness.expect(places)

    @property
    def _own_numbers(self) -> set[int | None]:
        """The device numbers of packets to the board that was read; `None` in compact ones."""
        stored = self._state.parameters.get(ParameterKey.DEVICE_NUMBER)
        return {None, stored, self._line.settings.device_number}

    def _keep_cleared(self, value: object) -> None:
        """Report bits that a packet of the user's has read, and so cleared."""
        match value:
            case Status():
                self._status.uart_due |= bool(value & Status.UART_ERROR)
                latched = LatchedStatus(self._now(), value, UartError(0))
            case UartError():
                latched = LatchedStatus(self._now(), Status(0), value)
            case _:
                return
        if value:
            self._note_status(latched)
            self._batcher.add(latched)

    def _write(self, job: Write) -> Written:
        """Write until it is done or `Close` comes, which leaves no value half written.

        Motors that may be moving are stopped before that. If another board replies, it is read and
        nothing counts as written.
        """
        state, stop_is_due = self._state, True
        parameters, stored = dict(job.parameters), state.parameters.get(ParameterKey.DEVICE_NUMBER)
        is_addressed = self._line.settings.device_number is not None
        number = parameters.get(ParameterKey.DEVICE_NUMBER, stored)
        if number != stored:
            self._require_stopped()
        elif is_addressed and ParameterKey.FACTORY_RESET in parameters:
            number = state.specs[ParameterKey.DEVICE_NUMBER].default  # from its next start on
        if number is not None and number != stored:
            require_free_number(self._line, number, self._serve_motors)

        def request(command: Command[ReplyT_co]) -> ReplyT_co:
            nonlocal stop_is_due
            if stop_is_due and self._is_closing() and self._motors.may_move:
                stop_is_due = False
                self._driver.stop_on_close()
            self._serve_motors()
            return self._line.request(command)

        try:
            results = write_all(
                request,
                state.specs,
                job.parameters,
                job.calibrations,
                self._report_progress,
                before=job.before or state,
                has_crc=self._line.has_crc,
                cancelled=self._is_closing,
                stored=self._note_stored,
            )
        except OtherBoard:
            self._state = state
            self._read_everything(ReadReason.RETURNED)
            raise
        failures = NoReply | BadReply | Rejected | PortUnavailable
        if any(isinstance(result.error, failures) for result in results):
            self._stale_reads = _STALE_READS  # what failed may be stored all the same
        return Written(results, self._state, self._line.settings)

    def _note_stored(self, result: WriteResult) -> None:
        self._state = after_writing(self._state, (result,))

    # --- Reading ------------------------------------------------------------------------

    def _read_everything(self, occasion: ReadReason) -> None:
        """Read everything and report it; unless it is merely reloaded, nothing drives meanwhile.

        The window does not know yet that the board was without power, or is another one, and
        goes on sending setpoints. Every motor is stopped and has to be armed again.
        """
        if occasion.power_cycled:
            self._motors.handle(OutputEvent.LOCK_OUT, self._now())
        self._state = read_everything(
            self._request, self._report_progress, has_crc=self._line.has_crc
        )
        number = self._state.parameters.get(ParameterKey.DEVICE_NUMBER)
        if occasion is ReadReason.OPENED and number is not None and is_several(self._line, number):
            where = self._line.settings.label, self._line.settings.line.text()
            raise TrexBadReplyError(ErrorCode.SEVERAL_BOARDS, *where)
        self._stale_reads = 0
        self._signature = self._state.signature
        if occasion is not ReadReason.RELOADED:
            if occasion.power_cycled or self._motors.is_armed:
                self._motors.handle(OutputEvent.LOCK_OUT, self._now())
            self._stop_if_moving()
        self._polling.start(self._state.source, self._now())
        self._liveness.begin()
        self._motors.handle(OutputEvent.BOARD_READ, self._now())
        self._transport.wait_for_guardian()
        self._report_guardian()
        if occasion is not ReadReason.SELECTED:  # what was sampled meanwhile is of the new board
            self._flush()
        client = self._line
        self._emit(
            Connected(
                self._state,
                client.echo,
                occasion,
                client.settings,
                self._motors.may_move,
                self._port_rates,
                self._queue.selection,
            )
        )

    def _next_topic(self, now: float) -> Topic | None:
        return self._polling.next(
            now,
            self._line.settings.line,
            self._state.serial_timeout,
            armed=self._motors.is_armed,
            careful=self._driver.avoids_risky_polls(),
        )

    def _poll(self, topic: Topic) -> None:
        try:
            # Stops and setpoints have just been served; only a status may take two transactions.
            request = self._request if topic is LatchedStatus else self._line.request
            sample = poll(request, topic, self._now, self._status)
            self._liveness.note_answer(topic)
            if topic is LatchedStatus:
                self._note_status(sample if isinstance(sample, LatchedStatus) else None)
            if sample is not None:
                self._batcher.add(sample)
            if isinstance(sample, Currents):
                self._motors.restart.note_currents(sample.counts, sample.time)
            if self._motors.restart.has_restarted:
                confirmed = self._driver.stop_and_confirm()
                self._emit(MotorsStopped(ErrorCode.MAY_HAVE_RESTARTED, confirmed))
                self._read_everything(ReadReason.RETURNED)
            elif isinstance(sample, ModeSample) and sample.mode is not self._state.mode:
                # The power was off and a jumper was moved: everything may have changed.
                self._stop_if_moving()
                self._read_everything(ReadReason.RESTARTED)
            elif self._stale_reads and self._now() >= self._stale_read_at:
                self._stale_reads -= 1
                self._stale_read_at = self._now() + _STALE_READ_INTERVAL
                self._read_everything(ReadReason.RELOADED)
        except (NoReply, BadReply) as error:
            self._note_failure(error, topic)

    def _check_safety_parameter(self, now: float) -> None:
        """Read a stored value that decides what the board does by itself to protect motors.

        If it changed unnoticed, the power was off too briefly for a missing reply: everything is
        read, and motors have to be armed again.
        """
        self._safety_read_at = now + _SAFETY_READ_INTERVAL
        key = next(self._safety_keys)
        known = self._state.parameters.get(key)
        if known is None:
            return
        command = GetParameter(self._state.specs[key].number)
        try:
            if self._line.request(command) == known:
                return
            if agreed(self._request, command, has_crc=self._line.has_crc) != known:
                # A failed write may have changed it as well.
                occasion = ReadReason.RELOADED
                if not self._stale_reads:
                    occasion = ReadReason.SETTING_CHANGED
                    self._stop_if_moving()
                self._read_everything(occasion)
        except (NoReply, BadReply) as error:
            self._note_failure(error)

    def _note_status(self, latched: LatchedStatus | None) -> None:
        stops_on_error = self._state.parameters.get(ParameterKey.UART_ERROR_SHUTDOWN)
        self._motors.note_status(
            latched,
            self._now(),
            is_whole=not self._status.uart_due,
            stops_on_error=bool(stops_on_error),
        )

    # --- A board that does not respond --------------------------------------------------

    def _note_failure(self, error: StudioError, topic: Topic | None = None) -> None:
        self._motors.restart.note_lost_reply()
        if self._liveness.note_failure(self._now(), topic):
            self._motors.handle(OutputEvent.NOT_RESPONDING, self._now())
            self._driver.stop_without_reply()
            self._flush()
            self._emit(NotResponding(str(error), replace(self._line.counters)))

    def _try_to_reconnect(self) -> None:
        """Query the board, or probe the next candidate."""
        try:
            self._driver.stop_without_reply()
            if not self._liveness.is_scanning(self._line):
                self._request_mode(self._line)
            elif (found := self._liveness.look(self._line)) is not None:
                self._client = self._driver.client = found
                self._status.begin()
            else:
                return
            self._stop_if_moving()
            self._read_everything(ReadReason.RETURNED)
        except (NoReply, BadReply):
            self._liveness.retry_later(self._now())

    def _request_mode(self, client: TrexClient) -> None:
        """Query the board; an echo that has begun or ended makes its replies unreadable."""
        try:
            client.request(GetMode())
        except (NoReply, BadReply) as error:
            if isinstance(error, TrexError) and error.code is ErrorCode.NO_REPLY:
                raise
            client.detect_echo()
            client.request(GetMode())
