"""Simulated Aracna on its line: board, polled UART and servos."""

from collections import deque
from collections.abc import Callable, Sequence
from functools import partial

from trex_gui.core.simulator.line import SimulatedLine
from trex_gui.core.simulator.sampling import RateConverter, ReceiveError, rates_differ
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.aracna.protocol.joints import CENTER, MOTORS
from trex_gui.devices.aracna.simulator.firmware import (
    Firmware,
    Pause,
    Program,
    Receive,
    State,
    Transmit,
)
from trex_gui.devices.aracna.simulator.servos import Servo

LINE = SerialFormat(38_400)  # settings of a matching host: 38400 8N1
REAL_BAUD = 16_000_000 / 16 / 26  # 38461.5 bit/s, from a clock of 16 MHz
STORED_BYTES = 3  # capacity of the UART while the program is busy: two buffers and a shift register

_OLD_MOTORS = 2  # number of motors of version 0 (22 Sep 2012)


class RobotStation:
    """Board with its firmware.

    The UART is polled, not interrupt-driven: bytes are read only while the program waits for them.
    The transmitter is double-buffered, and the program waits only until the buffer is free.
    Therefore, the program already reads while the last two bytes of a reply are still being sent.

    Attributes:
        keeps_last: if more than three bytes arrive, the UART stores the first two and the last
            (True), or the first three (False). According to the data sheet, a new byte replaces
            the byte in the shift register. Observed: a `.v` in reply to `.h` restarts the firmware
            repeatedly. This happens only if the last byte is stored.
    """

    line_format = LINE
    baud = REAL_BAUD

    def __init__(self, firmware: Firmware, line: SimulatedLine) -> None:
        self.firmware = firmware
        self.powered = False
        self.held: deque[int] = deque()  # bytes received while the program was busy
        self.keeps_last = True
        self.bytes_missed = 0
        self._line = line
        self._program: Program | None = None
        self._is_waiting = False
        self._moved_at = 0.0  # time at which the last byte enters the shift register
        self._sent_at = 0.0  # time at which the last byte is completely sent
        self._input = RateConverter(line.timeline, LINE, LINE.baud, self._receive_sampled)
        self._output: RateConverter | None = None

    def advance(self, seconds: float) -> None:
        for servo in self.firmware.servos:
            servo.advance(seconds)

    def power_on(self) -> None:
        if not self.powered:
            self.powered = True
            self._program = self.firmware.program()
            self._do(next(self._program))

    def power_off(self) -> None:
        self.powered = False
        self._program = None
        self._is_waiting = False
        self.held.clear()
        self._moved_at = self._sent_at = 0.0
        self.firmware.state = State.OFF
        self.firmware.led = False

    def reset(self) -> None:
        """Reset the board, but not its servos."""
        self.power_off()
        self.power_on()

    def receive(
        self, byte: int, host: SerialFormat | None, _error: ReceiveError | None, _begun: float
    ) -> None:
        # Assumed: the firmware ignores framing errors and uses the byte.
        self._receive(self._line.faults.garble(byte) if _is_other_parity(host) else byte)

    def sample(self, byte: int, host: SerialFormat) -> None:
        self._input.receive(byte, host, host.baud, paced=self._line.paced)

    def _receive_sampled(self, byte: int, _error: ReceiveError | None, _begun: float) -> None:
        self._line.faults.counters["garbled"] += 1
        self._receive(byte)

    def _receive(self, byte: int) -> None:
        if not self.powered:
            return
        if len(self.held) < STORED_BYTES:
            self.held.append(byte)
        else:
            self.bytes_missed += 1
            if self.keeps_last:
                self.held[-1] = byte
        if self._is_waiting:
            self._run(self.held.popleft())

    def _transmit(self, byte: int) -> None:
        line, host = self._line, self._line.host
        if host is not None and rates_differ(host.baud, self.baud):
            if self._output is None or self._output.line != host:
                self._output = RateConverter(line.timeline, host, host.baud, self._arrive_sampled)
            self._output.receive(byte, LINE, LINE.baud, paced=line.paced)
        else:
            arriving = line.faults.garble(byte) if _is_other_parity(host) else byte
            line.transmit(arriving, self, self._restart_check())

    def _arrive_sampled(self, byte: int, _error: ReceiveError | None, begun: float) -> None:
        self._line.faults.counters["garbled"] += 1
        self._line.arrive(byte, begun)

    def _run(self, byte: int = 0) -> None:
        self._is_waiting = False
        if self._program is not None:
            self._do(self._program.send(byte))

    def _do(self, request: Pause | Transmit | Receive) -> None:
        line, is_current = self._line, self._restart_check()
        match request:
            case Pause(seconds):
                line.timeline.at(line.now + seconds, self._run, is_current)
            case Transmit(byte):
                written_at = max(line.now, self._moved_at)
                self._moved_at = max(written_at, self._sent_at)
                self._sent_at = self._moved_at + line.byte_time_of(self)
                line.timeline.at(self._moved_at, partial(self._transmit, byte), is_current)
                line.timeline.at(written_at, self._run, is_current)
            case Receive() if self.held:
                line.timeline.at(line.now, lambda: self._run(self.held.popleft()), is_current)
            case Receive():
                self._is_waiting = True

    def _restart_check(self) -> Callable[[], bool]:
        """Return a function that returns True until the board is reset or switched off."""
        program = self._program
        return lambda: self._program is program


class AracnaLine(SimulatedLine):
    """Robot with its wire. Motions and the boot take time even on an unpaced line."""

    def __init__(
        self,
        motors: int = MOTORS,
        *,
        paced: bool = True,
        seed: int = 0,
        version: int | None = None,
        positions: Sequence[int] | None = None,
        boot_loader: float = 0.0,
    ) -> None:
        """Create a robot that is switched on.

        `version`: by default 0 with two motors, otherwise 1. `positions`: by default the centre.
        `boot_loader`: seconds before each `.h`.
        """
        super().__init__(paced=paced, seed=seed)
        if version is None:
            version = 0 if motors == _OLD_MOTORS else 1
        self.servos = tuple(map(Servo, positions or (CENTER,) * motors))
        self.station = RobotStation(Firmware(self.servos, version, boot_loader), self)
        self.stations = (self.station,)
        self.station.power_on()


def _is_other_parity(host: SerialFormat | None) -> bool:
    return host is not None and host.parity is not Parity.NONE
