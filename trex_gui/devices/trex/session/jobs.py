"""Execution of requests queued for a board. Every request has an outcome."""

from dataclasses import replace

from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.core.session import Outcome
from trex_gui.devices.trex.client.reading import ATTEMPTS, board_at, require_free_number
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.writing import WriteResult, after_writing, write_all
from trex_gui.devices.trex.driving.motor_driver import stop_together
from trex_gui.devices.trex.driving.motor_output import OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.commands import Command, ReplyT_co
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    OtherBoard,
    Rejected,
    TrexNoReplyError,
    TrexRequestError,
)
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.session.board_reader import BoardReader
from trex_gui.devices.trex.session.messages import (
    Job,
    ProbeNumber,
    ReadReason,
    Reload,
    SelectBoard,
    SendPacket,
    Write,
    Written,
)
from trex_gui.devices.trex.session.open_line import OpenLine
from trex_gui.devices.trex.session.reconnecting import reconnect_candidates


class JobServer:
    def __init__(self, line: OpenLine, reader: BoardReader) -> None:
        self._line = line
        self._reader = reader

    def serve(self, job: Job) -> None:
        line = self._line
        try:
            value = self._result_of(job)
        except (BadRequest, NoReply, BadReply, Rejected, OtherBoard) as error:
            line.emit(Outcome(job.id, error=error))
        except BaseException:
            # The session ends and reports an outcome for every queued request.
            line.queue.jobs.appendleft(job)
            raise
        else:
            line.emit(Outcome(job.id, value))

    def _result_of(self, job: Job) -> object:
        line = self._line
        if line.liveness.is_scanning(line.client):
            # Nothing may be sent to a board whose settings are unknown.
            raise TrexNoReplyError(ErrorCode.SCANNING)
        match job:
            case SendPacket(packet=packet):
                return self._send_packet(packet)
            case Write():
                return self._write(job)
            case Reload():
                reason = ReadReason.RETURNED if line.liveness.is_silent else ReadReason.RELOADED
                self._reader.read_everything(reason)
                return None
            case ProbeNumber(number=number, attempts=attempts):
                line.require_stopped()
                return board_at(line.client, number, attempts=attempts)
            case SelectBoard():
                self._select(job)
                return None

    def _select(self, job: SelectBoard) -> None:
        """Select another board after the current board has confirmed its stop.

        Setpoints are dropped. Arming has no effect until everything is read. After that, an `Arm`
        must contain the new `selection`.
        """
        line = self._line
        line.require_alone()
        motors, client, before = line.motors, line.client, line.client.settings
        selection = line.queue.selection
        motors.handle(OutputEvent.STOP, line.now())
        if motors.may_move:
            if not line.driver.stop_and_confirm():
                raise TrexNoReplyError(ErrorCode.NOT_SELECTED_MOVING, job.number)
            line.emit(MotorsStopped(None, confirmed=True))
        motors.handle(OutputEvent.NOT_RESPONDING, line.now())
        line.flush()
        try:
            if before.device_number is None and line.has_driven:
                self._stop_all(job)
            self._address(job)
        except BaseException:
            client.settings = before
            line.queue.selection = selection
            line.status.uart_due = True
            if not line.liveness.is_silent:
                motors.handle(OutputEvent.BOARD_READ, line.now())
            raise
        line.liveness.set_candidates(())  # the candidates were for the previous board

    def _address(self, job: SelectBoard) -> None:
        client = self._line.client
        if board_at(client, job.number, attempts=ATTEMPTS) is None:
            raise TrexNoReplyError(ErrorCode.NOT_SELECTED_SILENT, job.number)
        client.settings = replace(client.settings, device_number=job.number)
        self._line.queue.selection = job.id
        self._line.status.reset()
        self._reader.read_everything(ReadReason.SELECTED)

    def _stop_all(self, job: SelectBoard) -> None:
        """Stop all boards that commands without a device number have driven."""
        for number in job.sharing:
            self._line.client.settings = replace(self._line.client.settings, device_number=number)
            self._line.motors.handle(OutputEvent.DIRECT_COMMAND_SENT, self._line.now())
            if not self._line.driver.stop_and_confirm():
                raise TrexNoReplyError(ErrorCode.NOT_SELECTED_MOVING, job.number)
        self._line.has_driven = False

    def _send_packet(self, packet: RawPacket) -> bytes:
        line = self._line
        if not packet.is_query and not packet.moves:
            line.require_alone()  # the packet may change the device number
        if packet.moves:
            line.client.discard_late_reply()  # a stop may be requested during the wait
            number = line.client.settings.device_number
            if not line.motors.is_armed:
                raise TrexRequestError(ErrorCode.NOT_ARMED)
            if not packet.is_within_stop(number):
                raise TrexRequestError(ErrorCode.MOVES_ANOTHER_BOARD, number)
            line.driver.start_direct()
        else:
            line.collect()
            line.serve_motors()
        try:
            reply = line.client.send_packet(packet.packet)
        except (NoReply, BadReply):
            line.status.uart_due = True  # the packet may have cleared bits
            if packet.writes:
                self._reader.expect_changes()
            raise
        stored = self._reader.state.parameters.get(ParameterKey.DEVICE_NUMBER)
        if packet.device_number in {None, stored, line.client.settings.device_number}:
            self._report_cleared(reply.value)
        if packet.writes:
            self._read_after_write()
        return reply.raw

    def _read_after_write(self) -> None:
        before = self._reader.state.parameters
        self._reader.read_everything(ReadReason.RELOADED)
        state = self._reader.state
        candidates = reconnect_candidates(
            self._line.client.settings, before, state.parameters, state.signature.firmware
        )
        if candidates:
            self._line.liveness.set_candidates(candidates)

    def _report_cleared(self, value: object) -> None:
        status = self._line.status
        if isinstance(value, Status):
            status.uart_due |= bool(value & Status.UART_ERROR)
        if value and isinstance(value, Status | UartError):
            bits = (value, UartError(0)) if isinstance(value, Status) else (Status(0), value)
            latched = LatchedStatus(self._line.now(), *bits, is_whole=not status.uart_due)
            self._reader.record_status(latched)
            self._line.batcher.add(latched)

    def _write(self, job: Write) -> Written:
        """Write all values. After `Close`, only complete the current value.

        A `Close` first stops motors that may be moving. If another board replies, that board is
        read, and no value counts as written.
        """
        line = self._line
        state, stop_is_due = self._reader.state, True
        parameters, stored = dict(job.parameters), state.parameters.get(ParameterKey.DEVICE_NUMBER)
        is_addressed = line.client.settings.device_number is not None
        number = parameters.get(ParameterKey.DEVICE_NUMBER, stored)
        if number != stored:
            line.require_alone()
            line.require_stopped()
        elif is_addressed and ParameterKey.FACTORY_RESET in parameters:
            number = state.specs[ParameterKey.DEVICE_NUMBER].default  # value after the next start
        if number is not None and number != stored:
            require_free_number(line.client, number, line.serve_motors)

        def request(command: Command[ReplyT_co]) -> ReplyT_co:
            nonlocal stop_is_due
            moves = any(board.motors.may_move for board in line.boards)
            if stop_is_due and line.requests.sees_close() and moves:
                stop_is_due = False
                stop_together([board.driver.closing_stop() for board in line.boards])
            line.serve_motors()
            return line.client.request(command)

        try:
            results = write_all(
                request,
                state.specs,
                job.parameters,
                job.calibrations,
                line.report_progress,
                before=job.before or state,
                has_crc=line.client.has_crc,
                cancelled=line.requests.sees_close,
                on_stored=self._record_stored,
            )
        except OtherBoard:
            self._reader.state = state
            self._reader.read_everything(ReadReason.RETURNED)
            raise
        failures = NoReply | BadReply | Rejected | PortUnavailable
        if any(isinstance(result.error, failures) for result in results):
            self._reader.expect_changes()
        return Written(results, self._reader.state, line.settings)

    def _record_stored(self, result: WriteResult) -> None:
        self._reader.state = after_writing(self._reader.state, (result,))
