"""The wire between a host and one or several boards, in virtual time.

Bytes take as long as they take, a board that transmits is deaf, and the wire can be spoilt.
Nothing here waits: `advance` moves wire and boards forward together, event by event.
"""

import heapq
import math
import random
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import count

from trex_gui.emulator.firmware import Board
from trex_gui.emulator.uart import Reply, SerialPort
from trex_gui.protocol.flags import UartError
from trex_gui.protocol.line_settings import Detection, LineSettings

_BAUD_TOLERANCE = 0.03
"""How far two UARTs may be apart: half a bit in the ten of a byte, for both together."""

_EPSILON = 1e-12

_PARITIES = {Detection.EVEN: "even", Detection.ODD: "odd"}


@dataclass(slots=True, eq=False)
class _Node:
    """A board at the wire, and until when it transmits, unless its power goes before."""

    board: Board
    port: SerialPort
    deaf_until: float = -math.inf
    deaf_boot: int = 0

    def is_deaf(self, now: float) -> bool:
        """Whether it transmits, and so hears nothing."""
        return now < self.deaf_until - _EPSILON and _is_up(self.board, self.deaf_boot)


@dataclass(slots=True, eq=False)
class _Frame:
    """A byte on its way to the host, and who puts it on the wire."""

    start: float
    end: float
    value: int
    senders: set[int] = field(default_factory=set)


class Line:
    """One wire, the boards on it and the faults it has.

    The outputs of several boards are ANDed, as they must be on a real wire: what two of them
    say at the same time arrives as the AND of it.

    Attributes:
        boards, numbers: the boards, and the device numbers they had at first; these name them.
        echo: whether what the host sends comes back, as on the RS-232 connector.
        paced: whether bytes take their time on the wire.
        host: what the host has set its port to; `None` assumes that it fits.
        mute: whether nothing reaches the host.
        plugged: whether the cable is in.
        noise: probability that a byte is spoilt on its way.
        to_drop: how many of the next bytes to the host get lost.
        to_drop_sent: how many of the next bytes from the host get lost.
        now: seconds since the line was made.
        counters: what the wire did.
    """

    def __init__(
        self,
        boards: Sequence[Board],
        *,
        echo: bool = False,
        paced: bool = True,
        seed: int = 0,
    ) -> None:
        if not boards:
            raise ValueError("a line needs a board")
        self.boards = tuple(boards)
        self.numbers = tuple(board.eeprom["device_number"] for board in boards)
        self.echo = echo
        self.paced = paced
        self.host: LineSettings | None = None
        self.mute = False
        self.plugged = True
        self.noise = 0.0
        self.to_drop = 0
        self.to_drop_sent = 0
        self.now = 0.0
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("sent", "received", "dropped", "spoilt", "garbled", "collisions"), 0)
        )
        self._nodes = [_Node(board, SerialPort(board)) for board in boards]
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._events: list[tuple[float, int, Callable[[], None]]] = []
        self._order = count()
        self._host_busy_until = 0.0
        self._in_flight: list[_Frame] = []
        self._received = bytearray()

    # The host's end

    def send(self, data: bytes) -> None:
        """Queue bytes that the host sends now."""
        for byte in data:
            start = max(self.now, self._host_busy_until)
            end = start + self._host_byte_time()
            self._host_busy_until = end
            self._at(end, partial(self._reach_boards, byte, self.host))
            if self.echo:
                self._put_on_wire(_Frame(start, end, byte, {-1}))

    def receive(self) -> bytes:
        """Take what has reached the host so far."""
        data = bytes(self._received)
        self._received.clear()
        return data

    def read(self, size: int, seconds: float) -> bytes:
        """Let time pass until `size` bytes have come or `seconds` are over; return them."""
        end = self.now + seconds
        while len(self._received) < size and self._next() <= end + _EPSILON:
            self._step()
        if len(self._received) < size:
            self._move_to(end)
        data = bytes(self._received[:size])
        del self._received[:size]
        return data

    @property
    def backlog(self) -> float:
        """Seconds that the bytes which the host has queued still need to get onto the wire."""
        return max(0.0, self._host_busy_until - self.now)

    # Time

    def advance(self, seconds: float) -> None:
        """Let time pass."""
        self.advance_to(self.now + seconds)

    def advance_to(self, end: float) -> None:
        """Let time pass until a moment; one that is over already changes nothing."""
        while self._next() <= end + _EPSILON:
            self._step()
        self._move_to(end)

    @property
    def next_event(self) -> float | None:
        """When something happens on the wire next, if anything is under way."""
        return self._events[0][0] if self._events else None

    def _next(self) -> float:
        return self._events[0][0] if self._events else math.inf

    def _step(self) -> None:
        at, _, action = heapq.heappop(self._events)
        self._move_to(at)
        action()

    def _move_to(self, moment: float) -> None:
        if moment > self.now:
            seconds, self.now = moment - self.now, moment
            for board in self.boards:
                board.advance(seconds)

    def _at(self, moment: float, action: Callable[[], None]) -> None:
        heapq.heappush(self._events, (moment, next(self._order), action))

    # From the host to the boards

    def _host_byte_time(self) -> float:
        if not self.paced:
            return 0.0
        if self.host is not None:
            return self.host.seconds(1)
        return _byte_time(self.boards[0])

    def _reach_boards(self, byte: int, sender: LineSettings | None) -> None:
        self.counters["sent"] += 1
        if not self.plugged:
            return
        if self.to_drop_sent:
            self.to_drop_sent -= 1
            self.counters["dropped"] += 1
            return
        error = None
        if self._is_spoilt():
            byte, error = self._spoil(byte)
        for node in self._nodes:
            self._reach_board(node, byte, sender, error)

    def _reach_board(
        self, node: _Node, byte: int, sender: LineSettings | None, error: UartError | None
    ) -> None:
        if node.is_deaf(self.now):
            node.board.counters["bytes_missed"] += 1
            return
        parity_is_on = node.board.memory.line_settings.detection in _PARITIES
        if error is UartError.PARITY and not parity_is_on:
            error = None  # nobody notices the wrong bit
        error = _misread(node.board, sender) or error
        if error is not None:
            node.port.feed_error(error)
        elif (reply := node.port.feed(byte)) is not None:
            self._answer(node, reply)

    # From the boards to the host

    def _answer(self, node: _Node, reply: Reply) -> None:
        boot = node.board.boots
        self._at(self.now + reply.delay, partial(self._transmit, node, boot, reply.data))

    def _transmit(self, node: _Node, boot: int, data: bytes) -> None:
        if not _is_up(node.board, boot):
            return
        byte_time = _byte_time(node.board) if self.paced else 0.0
        begin = self.now
        node.deaf_until, node.deaf_boot = begin + len(data) * byte_time, boot
        sender = self._nodes.index(node)
        garbled = _misread(node.board, self.host) is not None
        for index, byte in enumerate(data):
            start = begin + index * byte_time
            self._at(start, partial(self._begin_byte, node, boot))
            value = self._garble(byte) if garbled else byte
            frame = _Frame(start, start + byte_time, value, {sender})
            self._put_on_wire(frame, partial(_is_up, node.board, boot))
        self._at(node.deaf_until, partial(self._resume, node, boot))

    @staticmethod
    def _begin_byte(node: _Node, boot: int) -> None:
        if _is_up(node.board, boot):
            node.board.counters["bytes_sent"] += 1

    def _resume(self, node: _Node, boot: int) -> None:
        if _is_up(node.board, boot) and (reply := node.port.resume()) is not None:
            self._answer(node, reply)

    def _put_on_wire(self, frame: _Frame, alive: Callable[[], bool] = lambda: True) -> None:
        for other in self._in_flight:
            if _collide(frame, other):
                other.value &= frame.value
                other.senders |= frame.senders
                self.counters["collisions"] += 1
                return
        if len(self.boards) + self.echo > 1:  # else nobody is there to collide with
            self._in_flight.append(frame)
        self._at(frame.end, partial(self._reach_host, frame, alive))

    def _reach_host(self, frame: _Frame, alive: Callable[[], bool]) -> None:
        self._in_flight = [other for other in self._in_flight if other is not frame]
        if not alive() or not self.plugged or self.mute:
            return
        if self.to_drop:
            self.to_drop -= 1
            self.counters["dropped"] += 1
            return
        value = frame.value
        if self._is_spoilt():
            self.counters["spoilt"] += 1
            value ^= 1 << self._random.randrange(8)
        self._received.append(value)
        self.counters["received"] += 1

    # Faults

    def inject(self, data: bytes) -> None:
        """Put bytes on the wire to the host that no board has sent."""
        byte_time = _byte_time(self.boards[0]) if self.paced else 0.0
        for index, byte in enumerate(data):
            start = self.now + index * byte_time
            self._put_on_wire(_Frame(start, start + byte_time, byte, {-2}))

    def unplug(self) -> None:
        """Pull the cable: nothing passes until it is back in."""
        self.plugged = False
        self._received.clear()

    def plug(self) -> None:
        """Put the cable back in."""
        self.plugged = True

    def _is_spoilt(self) -> bool:
        return self.noise > 0 and self._random.random() < self.noise

    def _spoil(self, byte: int) -> tuple[int, UartError | None]:
        """Turn one bit round: a data bit, which parity notices, or the stop bit."""
        self.counters["spoilt"] += 1
        bit = self._random.randrange(9)
        if bit == 8:
            return byte, UartError.FRAMING
        return byte ^ 1 << bit, UartError.PARITY

    def _garble(self, byte: int) -> int:
        """Return what a host with other settings makes of a byte: never the byte itself."""
        self.counters["garbled"] += 1
        return byte ^ self._random.randrange(1, 256)


def _byte_time(board: Board) -> float:
    return board.memory.line_settings.bits_per_byte / board.memory.baud


def _is_up(board: Board, boot: int) -> bool:
    """Whether a board has had power without a break since that power-up."""
    return board.powered and board.boots == boot


def _misread(board: Board, host: LineSettings | None) -> UartError | None:
    """Return the error that each byte gives when host and board are set differently.

    A real receiver would take some of such bytes for good ones. Here none is: what a test
    sees does not depend on luck, and no motor starts for it.
    """
    if host is None:
        return None
    own = board.memory.line_settings
    if abs(host.baud / board.memory.baud - 1) > _BAUD_TOLERANCE:
        return UartError.FRAMING
    wanted, given = _PARITIES.get(own.detection), _PARITIES.get(host.detection)
    if wanted != given:
        return UartError.PARITY if wanted else UartError.FRAMING
    return None if own.stop_bits == host.stop_bits else UartError.FRAMING


def _collide(frame: _Frame, other: _Frame) -> bool:
    """Whether two bytes of different senders are on the wire at the same time."""
    if frame.senders & other.senders:
        return False
    if frame.start == frame.end:  # not paced: bytes pair in their order
        return frame.start == other.start
    return frame.start < other.end - _EPSILON and other.start < frame.end - _EPSILON
