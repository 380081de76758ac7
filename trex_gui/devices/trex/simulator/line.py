"""Simulated boards on one line, with the timing of their bytes."""

import math
from collections.abc import Callable, Sequence
from functools import partial

from trex_gui.core.simulator.line import SimulatedLine
from trex_gui.core.simulator.sampling import (
    RateConverter,
    ReceiveError,
    Receiver,
    SampledByte,
    rates_differ,
)
from trex_gui.core.simulator.timeline import EPSILON
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.uart import SerialPort


class BoardStation:
    """Board on the line. It cannot receive while it transmits."""

    def __init__(self, board: Board, line: "SimulatedBoards") -> None:
        self.board = board
        self.port = SerialPort(board)
        self.advance = board.advance
        self._line = line
        self._boot = board.boots
        self._clock_offset = line.now - board.now  # the board may have started before the line
        self._receives_since = line.now
        self._discard_transfer()

    def _discard_transfer(self) -> None:
        self._is_transmitting = False
        self._is_pausing = False
        self._input: RateConverter | None = None  # bytes from a host at another baud rate
        self._output: RateConverter | None = None  # bytes to a host at another baud rate

    def _check_boot(self) -> None:
        if self._boot != self.board.boots:
            self._boot = self.board.boots
            self._receives_since = self.board.powered_at + self._clock_offset
            self._discard_transfer()

    def _is_up(self, boot: int) -> bool:
        return self.board.powered and self.board.boots == boot

    def _still_up(self) -> Callable[[], bool]:
        """Return a condition that is true until the board loses power."""
        return partial(self._is_up, self.board.boots)

    @property
    def line_format(self) -> LineSettings:
        return self.board.memory.line_settings

    @property
    def baud(self) -> float:
        return self.board.memory.baud

    # --- Receiving ----------------------------------------------------------------------

    def receive(
        self, byte: int, host: SerialFormat | None, error: ReceiveError | None, begun: float
    ) -> None:
        if error is ReceiveError.PARITY and self.line_format.parity is Parity.NONE:
            error = None  # a board without parity detects no parity errors
        if host is not None:
            error = self._format_error(host) or error
        self._receive(byte, error, begun)

    def sample(self, byte: int, host: SerialFormat) -> None:
        self._check_boot()
        if self._input is None:
            deliver = partial(self._handle_sampled, self._boot)
            self._input = RateConverter(self._line.timeline, self.line_format, self.baud, deliver)
        self._input.receive(byte, host, host.baud, paced=self._line.paced)

    def _handle_sampled(
        self, boot: int, byte: int, error: ReceiveError | None, begun: float
    ) -> None:
        if boot == self.board.boots:
            self._receive(byte, error, begun)

    def _receive(self, byte: int, error: ReceiveError | None, begun: float) -> None:
        self._check_boot()
        if self._is_transmitting or begun < self._receives_since - EPSILON:
            self.board.counters["bytes_missed"] += 1
        elif error is not None:
            self.port.feed_error(error)
        else:
            self.port.feed(byte)
            self._start_transfer()

    def _format_error(self, host: SerialFormat) -> ReceiveError | None:
        """Return the error for bytes with another parity or other stop bits.

        A real receiver accepts some of these bytes: half of them have the right parity by chance,
        and many UARTs check only one stop bit. The simulator rejects every byte, so that results
        are reproducible.
        """
        line = self.line_format
        if line.parity is not host.parity:
            return ReceiveError.FRAMING if line.parity is Parity.NONE else ReceiveError.PARITY
        return None if line.stop_bits == host.stop_bits else ReceiveError.FRAMING

    # --- Transmitting -------------------------------------------------------------------

    def _start_transfer(self) -> None:
        line = self._line
        if self.port.pause and not self._is_pausing:
            self._is_pausing = True
            line.timeline.at(line.now + self.port.pause, self._resume, self._still_up())
        if not self.port.outgoing or self._is_transmitting:
            return
        host = line.host
        if host is not None and rates_differ(host.baud, self.baud):
            self._is_transmitting = True
            if not line.paced:
                convert = partial(self._transmit_converted, host)
                line.timeline.at(line.now, convert, self._still_up())
                return
            deliver = partial(self._arrive_sampled, self._boot)
            self._output = RateConverter(line.timeline, host, host.baud, deliver)
        elif not line.paced and len(line.boards) == 1:
            self._transmit_at_once()
            return
        self._is_transmitting = True
        self._transmit()

    def _resume(self) -> None:
        self._is_pausing = False
        self.port.resume()
        self._start_transfer()

    def _pop_outgoing(self) -> bytes:
        data = bytes(self.port.outgoing)
        self.port.outgoing.clear()
        self.board.counters["bytes_sent"] += len(data)
        return data

    def _transmit_at_once(self) -> None:
        line, data = self._line, self._pop_outgoing()
        if not line.is_grounded:
            is_garbled = line.host is not None and self._format_error(line.host) is not None
            for byte in data:
                line.arrive(line.faults.garble(byte) if is_garbled else byte, line.now)

    def _transmit_converted(self, host: SerialFormat) -> None:
        receiver = Receiver(host, host.baud)
        sampled: list[SampledByte] = []
        for byte in self._pop_outgoing():
            sampled += receiver.receive(receiver.known_until, byte, self.line_format, self.baud)
        for received in (*sampled, *receiver.idle(math.inf)):
            self._arrive_sampled(self._boot, received.value, received.error, self._line.now)
        self._transmit()

    def _transmit(self) -> None:
        line = self._line
        if not self.port.outgoing:
            self._is_transmitting = False
            self._receives_since = line.now
            self._output = None
            return
        byte = self.port.outgoing.popleft()
        self.board.counters["bytes_sent"] += 1
        if self._output is not None:
            self._output.receive(byte, self.line_format, self.baud, paced=True)
        elif line.host is not None and self._format_error(line.host):
            byte = line.faults.garble(byte)
        if self._output is not None or line.is_grounded:
            end = line.now + line.byte_time_of(self)
            line.timeline.at(end, self._transmit, self._still_up())
        else:
            line.transmit(byte, self, self._still_up(), then=self._transmit)

    def _arrive_sampled(
        self, boot: int, byte: int, _error: ReceiveError | None, begun: float
    ) -> None:
        if self._is_up(boot) and not self._line.is_grounded:
            self.board.counters["bytes_garbled"] += 1
            self._line.arrive(byte, begun)


class SimulatedBoards(SimulatedLine):
    """Line with boards. `numbers` contains their initial device numbers."""

    def __init__(
        self, boards: Sequence[Board], *, echo: bool = False, paced: bool = True, seed: int = 0
    ) -> None:
        if not boards:
            raise ValueError("a line needs at least one board")
        super().__init__(echo=echo, paced=paced, seed=seed, noisy_bits=9)
        self.boards = tuple(boards)
        self.numbers = tuple(board.eeprom[ParameterKey.DEVICE_NUMBER] for board in boards)
        self.stations = tuple(BoardStation(board, self) for board in boards)

    @property
    def save_errors(self) -> list[str]:
        return [str(board.eeprom.unsaved) for board in self.boards if board.eeprom.unsaved]

    @property
    def is_grounded(self) -> bool:
        """True if a jumper grounds SO. Inferred: the host then receives nothing."""
        return any(board.so_ground for board in self.boards)
