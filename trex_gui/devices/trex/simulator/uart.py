"""UART and packet parser of the board, without a clock.

Ref: TReX 1.0 command documentation; Pololu TReX User's Guide 5.b (protocols), 5.e (CRC-7).
This module does not use `protocol.commands`. It implements the documentation independently.
"""

from collections import deque
from collections.abc import Callable
from dataclasses import astuple

from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.calibration import INVALID_RAW, Calibration
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.motors import MotorDirection

# Inferred sizes in bytes. The documentation says only that a host causes no overrun if it waits for
# replies. Therefore, each buffer has space for at least the longest packet or reply.
RECEIVE_BUFFER = 32
SEND_BUFFER = 32

_COMMAND_BIT = 0x80
_EXPANDED = 0x80
_NULL = 0xFF
_GAP = -1  # placeholder for lost bytes in the receive buffer
_UART_ERRORS = {
    ReceiveError.FRAMING: UartError.FRAMING,
    ReceiveError.PARITY: UartError.PARITY,
    ReceiveError.OVERRUN: UartError.DATA_OVERRUN,
}

_FORMAT_BYTES = b"\x55\x2a"


def remainder(data: bytes, polynomial: int) -> int:
    """Return the CRC-7 of a packet, by the long division in the guide (5.e).

    Seven zero bits are appended. The polynomial has eight bits (0x80-0xFF).
    """
    dividend = int.from_bytes(data) << 7
    while (excess := dividend.bit_length() - 8) >= 0:
        dividend ^= polynomial << excess
    return dividend


class SerialPort:
    """UART and packet parser of one board.

    The parser pauses for a write to the EEPROM and for the response delay. Bytes that arrive during
    a pause are processed after it, while the reply is transmitted.

    `outgoing` is the send buffer. `pause` is the time in seconds from the last byte to `resume`.
    """

    def __init__(self, board: Board) -> None:
        self.board = board
        self._boot = board.boots
        self._reply = b""  # reply to send after the pause
        self._reset()

    def feed(self, byte: int) -> None:
        if not self._is_listening():
            if self.board.boot_mode is not None:
                self._send(self.board.boot_mode.reply(byte))
            return
        self.board.record_byte()
        if not self.pause:
            self._receive(byte)
        elif len(self._buffer) - self._buffer.count(_GAP) < RECEIVE_BUFFER:
            self._buffer.append(byte)
        else:
            self._add_gap()
            self.board.report_error(UartError.READ_OVERRUN)

    def feed_error(self, error: ReceiveError) -> None:
        if self._is_listening():
            self.board.record_byte()
            if self.pause:
                self._add_gap()
            else:
                self._clear_packet()
            self.board.report_error(_UART_ERRORS[error])

    def _add_gap(self) -> None:
        if not self._buffer or self._buffer[-1] != _GAP:
            self._buffer.append(_GAP)

    def resume(self) -> None:
        if not self._is_listening():
            return
        self.pause = 0.0
        self._send(self._reply)
        self._reply = b""
        while self._buffer and not self.pause:
            self._receive(self._buffer.popleft())

    def _is_listening(self) -> bool:
        if self.board.boots != self._boot:
            self._boot = self.board.boots
            self._reset()
        return self.board.is_running

    def _reset(self) -> None:
        self._buffer: deque[int] = deque()
        self.outgoing: deque[int] = deque()
        self.pause = 0.0
        self._reply = b""
        self._clear_packet()

    def _clear_packet(self) -> None:
        self._packet = bytearray()
        self._is_skipping = False
        self.board.receiving = False

    def _receive(self, byte: int) -> None:
        if byte == _GAP:
            self._clear_packet()
        elif byte & _COMMAND_BIT:
            self._handle_command_byte(byte)
        elif self._is_skipping:
            pass  # data in a packet for another device; inferred: causes no error
        elif not self._packet:
            self._reject()  # inferred: a data byte without a packet is a format error
        else:
            self._packet.append(byte)
            self._parse_packet()

    def _handle_command_byte(self, byte: int) -> None:
        if self._packet:
            # Inferred: the byte that interrupts a packet starts the next packet.
            self._reject()
        self._clear_packet()
        if byte == _NULL:
            return  # inferred: a null command has no CRC
        self._packet.append(byte)
        self.board.receiving = True
        self._parse_packet()

    def _parse_packet(self) -> None:
        header_size = 1
        command = self._packet[0]
        if command == _EXPANDED:
            header_size = 3
            number = self.board.memory.active[ParameterKey.DEVICE_NUMBER]
            if len(self._packet) >= 2 and self._packet[1] != number:
                self.board.counters["packets_for_others"] += 1
                self._clear_packet()
                self._is_skipping = True
                return
            if len(self._packet) < header_size:
                return
            command = self._packet[2] | _COMMAND_BIT
            if command == _NULL:
                self._clear_packet()
                return
        if command not in _COMMANDS:
            self._reject()
            return
        size, handler = _COMMANDS[command]
        polynomial = self.board.memory.crc_polynomial
        if len(self._packet) < header_size + size + (polynomial is not None):
            return
        packet = bytes(self._packet)
        self._clear_packet()
        if polynomial is not None and remainder(packet[:-1], polynomial) != packet[-1]:
            self.board.report_error(UartError.CRC)
        else:
            self._execute(handler, command, packet[header_size : header_size + size])

    def _execute(self, handler: "_Handler", command: int, data: bytes) -> None:
        try:
            reply = handler(self.board, command, data)
        except _IllogicalData as error:
            self._reject()
            reply = error.args[0] if error.args else b""
        else:
            self.board.counters["packets"] += 1
        if not reply:
            return
        memory = self.board.memory
        polynomial = memory.crc_polynomial
        if polynomial is not None:
            reply += bytes([remainder(reply, polynomial)])
        self.pause = memory.busy_for + memory.response_delay
        if self.pause:
            self._reply = reply
        else:
            self._send(reply)

    def _send(self, reply: bytes) -> None:
        """Add a reply to the send buffer. Inferred: surplus bytes are lost."""
        space = SEND_BUFFER - len(self.outgoing)
        self.outgoing.extend(reply[:space])
        if len(reply) > space:
            self.board.report_error(UartError.SEND_OVERRUN)

    def _reject(self) -> None:
        self._clear_packet()
        self.board.report_error(UartError.FORMAT)


class _IllogicalData(Exception):  # noqa: N818 - a term of the documentation
    """A data byte has an invalid value. The optional argument is the reply."""


_Handler = Callable[[Board, int, bytes], bytes]  # board, command byte, data → reply or b""


def _read(reply: Callable[[Board], bytes]) -> tuple[int, _Handler]:
    return 0, lambda board, _command, _data: reply(board)


def _selected(data: bytes) -> list[int]:
    if data[0] > 0b11111:
        raise _IllogicalData  # inferred; there are only five channels
    return [index for index in range(5) if data[0] & 1 << index]


def _get_raw(board: Board, _command: int, data: bytes) -> bytes:
    raw = board.channels.raw
    values = [raw[index] for index in _selected(data)]
    return b"".join(
        (INVALID_RAW if value is None else value).to_bytes(2, "little") for value in values
    )


def _get_remapped(board: Board, _command: int, data: bytes) -> bytes:
    remapped = board.remapped
    values = (remapped[index] for index in _selected(data))
    return bytes(abs(value) | (0x80 if value < 0 else 0) for value in values)


def _get_calibration(board: Board, command: int, _data: bytes) -> bytes:
    values = astuple(board.calibration(command - 0x90 + 1))
    return b"".join(value.to_bytes(2, "little") for value in values)


def _get_parameter(board: Board, _command: int, data: bytes) -> bytes:
    value = board.memory.get(data[0])
    if value is None:
        # Inferred and twin: an unknown parameter number is illogical data.
        raise _IllogicalData(board.unknown_reply)
    return bytes([value])


def _require_format_bytes(data: bytes) -> None:
    if data[-2:] != _FORMAT_BYTES:
        raise _IllogicalData


def _set_calibration(board: Board, command: int, data: bytes) -> bytes:
    _require_format_bytes(data)
    # Inferred: the low and high bytes have seven bits each, because no data byte exceeds 127.
    calibration = Calibration(*(data[index] + 128 * data[index + 1] for index in range(0, 8, 2)))
    return bytes([board.set_calibration(command - 0xA0 + 1, calibration)])


def _set_parameter(board: Board, _command: int, data: bytes) -> bytes:
    _require_format_bytes(data)
    return bytes([board.set_parameter(data[0], data[1])])


def _drive_one(board: Board, command: int, data: bytes) -> bytes:
    """0xC0-0xCF: bit 3 selects the motor, bit 2 a ramp, and bits 1:0 the direction."""
    number = 2 if command & 0b1000 else 1
    direction = MotorDirection.from_bits(command)
    board.serial.drive(number, direction, data[0], accelerate=bool(command & 0b0100))
    return b""


def _drive_both(board: Board, command: int, data: bytes) -> bytes:
    """0xD0-0xEF: bits 1:0 are the direction of motor 1, bits 3:2 the direction of motor 2."""
    accelerate = command >= 0xE0
    board.serial.drive(1, MotorDirection.from_bits(command), data[0], accelerate=accelerate)
    board.serial.drive(2, MotorDirection.from_bits(command >> 2), data[1], accelerate=accelerate)
    return b""


def _drive_aux(board: Board, command: int, data: bytes) -> bytes:
    board.serial.drive_aux(data[0], accelerate=command == 0xF1)
    return b""


_COMMANDS: dict[int, tuple[int, _Handler]] = {  # command byte → data size, handler
    0x81: _read(lambda board: board.model.signature + board.firmware.encode("ascii")),
    0x82: _read(lambda board: board.mode.value.encode("ascii")),
    0x83: _read(lambda board: bytes([board.serial.in_control])),
    0x84: _read(lambda board: bytes([board.serial.pop_status()])),
    0x85: _read(lambda board: bytes([board.serial.pop_uart_errors()])),
    0x86: (1, _get_raw),
    0x87: (1, _get_remapped),
    0x8D: _read(lambda board: bytes([board.physics[0].reading])),
    0x8E: _read(lambda board: bytes([board.physics[1].reading])),
    0x8F: _read(lambda board: bytes(physics.reading for physics in board.physics)),
    **dict.fromkeys(range(0x90, 0x95), (0, _get_calibration)),
    0x95: _read(lambda board: bytes([board.eeprom.learned(board.mode.source)])),
    0x9F: (1, _get_parameter),
    **dict.fromkeys(range(0xA0, 0xA5), (10, _set_calibration)),
    0xAF: (4, _set_parameter),
    **dict.fromkeys(range(0xC0, 0xD0), (1, _drive_one)),
    **dict.fromkeys(range(0xD0, 0xF0), (2, _drive_both)),
    **dict.fromkeys(range(0xF0, 0xF2), (1, _drive_aux)),
}
