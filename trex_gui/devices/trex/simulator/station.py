"""A board at the wire, in time: when it hears, pauses and talks, and what the rates make of it."""

import math
from collections.abc import Callable, Iterable
from functools import partial
from typing import Protocol

from trex_gui.core.simulator.sampling import Receiver, SampledByte
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.shared_wire import Frame
from trex_gui.devices.trex.simulator.uart import SerialPort

_RATE_TOLERANCE = 0.03
"""How far two UARTs may be apart: half a bit in the ten of a byte, for both together."""

_EPSILON = 1e-9  # seconds; swallows the rounding of summed times


class BoardWire(Protocol):
    """What a board needs of the wire that it hangs on."""

    now: float
    paced: bool
    host: SerialFormat | None

    @property
    def is_instant(self) -> bool:
        """Whether bytes take no time and have nothing to collide with."""

    @property
    def is_grounded(self) -> bool:
        """Whether the wire to the host is held low."""

    def at(self, moment: float, action: Callable[[], None]) -> None:
        """Do something at a moment that is not over."""

    def put(self, frame: Frame) -> None:
        """Let a byte to the host begin now."""

    def arrive(self, byte: int, begun: float) -> None:
        """Let a byte reach the host now that began at a moment."""

    def garble(self, byte: int) -> int:
        """Return what a host with other parity or stop bits makes of a byte."""


class BoardOnWire:
    """One board at a wire. While it transmits it is deaf.

    Attributes:
        board, port: the board and its UART.
    """

    def __init__(self, board: Board, wire: BoardWire) -> None:
        self.board = board
        self.port = SerialPort(board)
        self._wire = wire
        self._boot = board.boots
        self._ahead = wire.now - board.now  # the board may be older than the wire
        self._hears_since = wire.now
        self._forget()

    def _forget(self) -> None:
        self._is_talking = False
        self._is_pausing = False
        self._ear: Receiver | None = None  # what it makes of a host at another rate
        self._mouth: Receiver | None = None  # what such a host makes of it

    def _is_new_boot(self) -> bool:
        """Whether it was powered up since we last looked; what was going on then is over."""
        if self._boot == self.board.boots:
            return False
        self._boot = self.board.boots
        self._hears_since = self.board.powered_at + self._ahead
        self._forget()
        return True

    @property
    def byte_time(self) -> float:
        """Seconds that a byte of its own takes."""
        memory = self.board.memory
        return memory.line_settings.bits_per_byte / memory.baud if self._wire.paced else 0.0

    def is_other_rate(self, host: SerialFormat) -> bool:
        """Whether a host runs at a rate at which neither understands the other."""
        return abs(host.baud / self.board.memory.baud - 1) > _RATE_TOLERANCE

    def hear(
        self, byte: int, host: SerialFormat | None, error: UartError | None, begun: float
    ) -> None:
        """Take a byte of a host that runs at its rate, at its end."""
        if error is UartError.PARITY and not self._has_parity:
            error = None  # nobody notices the wrong bit
        if host is not None:
            error = self._misread(host) or error
        self._take(byte, error, begun)

    def sample(self, byte: int, host: SerialFormat) -> None:
        """Take from the wire what it can of a byte that a host at another rate begins."""
        self._is_new_boot()
        if self._ear is None:
            memory = self.board.memory
            self._ear = Receiver(memory.line_settings, memory.baud)
        if not self._wire.paced:  # bytes take no time: each comes by itself
            for heard in self._ear.hear_alone(byte, host, host.baud):
                self._take(heard.value, heard.error, self._wire.now)
            return
        for heard in self._ear.hear(self._wire.now, byte, host, host.baud):
            self._wire.at(heard.at, partial(self._take_sampled, self._ear, heard))
        if (due := self._ear.due) is not None:
            self._wire.at(due, partial(self._end_sample, self._ear, due))

    def _end_sample(self, ear: Receiver, due: float) -> None:
        """Complete a byte behind which the host has been silent."""
        for heard in ear.rest(math.nextafter(due, math.inf)):
            self._take_sampled(ear, heard)

    def _take_sampled(self, ear: Receiver, heard: SampledByte) -> None:
        if not self._is_new_boot() and ear is self._ear:
            self._take(heard.value, heard.error, heard.begun)

    def _take(self, byte: int, error: UartError | None, begun: float) -> None:
        """Take a byte that has ended; one that began while it was deaf or off is lost."""
        self._is_new_boot()
        if self._is_talking or begun < self._hears_since - _EPSILON:
            self.board.counters["bytes_missed"] += 1
        elif error is not None:
            self.port.feed_error(error)
        else:
            self.port.feed(byte)
            self._attend()

    @property
    def _has_parity(self) -> bool:
        return self.board.memory.line_settings.parity is not Parity.NONE

    def _misread(self, host: SerialFormat) -> UartError | None:
        """Return the error that each byte gives when parity or stop bits are set differently.

        A real receiver would take some of such bytes for good ones (every other one has the
        right parity by chance, and many look at one stop bit only). Here none is: what a
        learner or a test sees does not depend on luck.
        """
        own = self.board.memory.line_settings
        wanted, given = own.parity, host.parity
        if wanted != given:
            return UartError.FRAMING if wanted is Parity.NONE else UartError.PARITY
        return None if own.stop_bits == host.stop_bits else UartError.FRAMING

    # Talking

    def _attend(self) -> None:
        """See to what the board does after a byte: pause, answer."""
        if self.port.pause and not self._is_pausing:
            self._is_pausing = True
            self._wire.at(self._wire.now + self.port.pause, self._while_up(self._resume))
        if self.port.outgoing and not self._is_talking:
            self._begin_to_talk()

    def _resume(self) -> None:
        self._is_pausing = False
        self.port.resume()
        self._attend()

    def _begin_to_talk(self) -> None:
        host = self._wire.host
        if host is not None and self.is_other_rate(host):
            self._mouth = Receiver(host, host.baud, self._wire.now)
        elif self._wire.is_instant:
            self._say_at_once()
            return
        self._is_talking = True
        self._talk()

    def _say_at_once(self) -> None:
        wire, outgoing = self._wire, self.port.outgoing
        self.board.counters["bytes_sent"] += len(outgoing)
        is_misread = wire.host is not None and self._misread(wire.host)
        for byte in outgoing:
            if wire.is_grounded:
                break
            wire.arrive(wire.garble(byte) if is_misread else byte, wire.now)
        outgoing.clear()

    def _talk(self) -> None:
        """Put the next byte of the send buffer on the wire, or fall silent."""
        if not self.port.outgoing:
            self._is_talking = False
            self._hears_since = self._wire.now
            mouth, self._mouth = self._mouth, None
            if mouth is not None:
                self._carry(mouth.rest(math.inf))
            return
        byte = self.port.outgoing.popleft()
        self.board.counters["bytes_sent"] += 1
        wire = self._wire
        if self._mouth is not None:
            memory = self.board.memory
            settings, baud = memory.line_settings, memory.baud
            begin = wire.now if wire.paced else self._mouth.known_until
            self._carry(self._mouth.hear(begin, byte, settings, baud))
        else:
            if wire.host is not None and self._misread(wire.host):
                byte = wire.garble(byte)
            memory, alive = self.board.memory, self._is_up(self.board.boots)
            end = wire.now + self.byte_time
            wire.put(Frame(wire.now, end, byte, memory.line_settings, memory.baud, alive))
        wire.at(wire.now + self.byte_time, self._while_up(self._talk))

    def _carry(self, heard: Iterable[SampledByte]) -> None:
        """Give the host what it makes of this board, which runs at another rate.

        What its receiver notices to be wrong is lost: a port gives such bytes to the program.
        """
        wire = self._wire
        for each in heard:
            if wire.is_grounded:
                continue
            self.board.counters["bytes_garbled"] += 1
            at = max(wire.now, each.at) if wire.paced else wire.now
            begun = each.begun if wire.paced else wire.now
            wire.at(at, self._while_up(partial(wire.arrive, each.value, begun)))

    def _is_up(self, boot: int) -> Callable[[], bool]:
        """Return whether the board will have had power without a break since that power-up."""
        return lambda: self.board.powered and self.board.boots == boot

    def _while_up(self, action: Callable[[], None]) -> Callable[[], None]:
        """Return the action, dropped if the power goes before it is due."""
        is_up = self._is_up(self.board.boots)

        def act() -> None:
            if is_up():
                action()

        return act
