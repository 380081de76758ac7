"""The wire between a host and one or several boards, in virtual time.

Bytes take as long as they take, a board that transmits is deaf, and the wire can be spoilt.
Nothing here waits: `advance` moves wire and boards forward together, event by event.
"""

import heapq
import math
import random
from collections import Counter, deque
from collections.abc import Callable, Sequence
from functools import partial
from itertools import count

from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.shared_wire import Frame, SharedWire
from trex_gui.devices.trex.simulator.station import BoardOnWire

_EPSILON = 1e-12  # seconds; swallows the rounding of summed times


class SimulatedLine:
    """One wire, the boards on it and the faults it has.

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
        to_spoil: what the boards' UARTs will find wrong with the next bytes from the host.
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
        self.now = 0.0
        self.numbers = tuple(board.eeprom[ParameterKey.DEVICE_NUMBER] for board in boards)
        self.echo = echo
        self.paced = paced
        self.host: SerialFormat | None = None
        self.mute = False
        self.plugged = True
        self.noise = 0.0
        self.to_drop = 0
        self.to_drop_sent = 0
        self.to_spoil: deque[UartError] = deque()
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("sent", "received", "dropped", "spoilt", "garbled", "collisions"), 0)
        )
        self._stations = [BoardOnWire(board, self) for board in boards]
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._events: list[tuple[float, int, Callable[[], None]]] = []
        self._order = count()
        self._host_busy_until = 0.0
        self._host_turn = 0
        self._plugged_at = -math.inf
        self._injecting_until = 0.0
        self._shared = SharedWire(self.at, self.arrive, self._host_settings, self.counters)
        self._received = bytearray()

    # The host's end

    def send(self, data: bytes) -> None:
        """Queue bytes that the host sends now."""
        host = self.host
        is_alien = host is not None and any(
            station.is_other_rate(host) for station in self._stations
        )
        byte_time = self._host_byte_time()
        for byte in data:
            start = max(self.now, self._host_busy_until)
            end = start + byte_time
            self._host_busy_until = end
            if self.echo:
                self._while_wanted(start, partial(self._echo, byte, end))
            if is_alien and host is not None:
                self._while_wanted(start, partial(self._carry_alien, byte, host, end))
            else:
                self._while_wanted(end, partial(self._carry, byte, host, start))

    def drop_unsent(self) -> None:
        """Forget what the host has queued: its port was closed, or set anew."""
        self._host_turn += 1
        self._host_busy_until = self.now

    @property
    def own_settings(self) -> SerialFormat:
        """What a host that fits the first board has set its port to."""
        return self.boards[0].memory.line_settings

    @property
    def unsaved(self) -> list[str]:
        """Why the memory of a board is not in its file; a sentence each."""
        return [str(board.eeprom.unsaved) for board in self.boards if board.eeprom.unsaved]

    def _while_wanted(self, moment: float, action: Callable[[], None]) -> None:
        """Do something for the host at a moment, unless what it had queued is dropped before."""
        turn = self._host_turn

        def act() -> None:
            if turn == self._host_turn:
                action()

        self.at(moment, act)

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

    def at(self, moment: float, action: Callable[[], None]) -> None:
        """Do something when a moment has come."""
        heapq.heappush(self._events, (moment, next(self._order), action))

    # From the host to the boards

    def _host_byte_time(self) -> float:
        if not self.paced:
            return 0.0
        if self.host is not None:
            return self.host.seconds(1)
        return self._stations[0].byte_time

    def _carry(self, byte: int, sender: SerialFormat | None, begun: float) -> None:
        """Let a byte of the host arrive at the boards, which all run at its rate."""
        if (fate := self._fate(byte, begun)) is not None:
            byte, error = fate
            for station in self._stations:
                station.hear(byte, sender, error, begun)

    def _carry_alien(self, byte: int, sender: SerialFormat, end: float) -> None:
        """Let a byte of the host begin that some boards cannot read."""
        begun = self.now
        if (fate := self._fate(byte, begun)) is None:
            return
        byte, error = fate
        for station in self._stations:
            if station.is_other_rate(sender):
                station.sample(byte, sender)
            else:
                self._while_wanted(end, partial(station.hear, byte, sender, error, begun))

    def _fate(self, byte: int, begun: float) -> tuple[int, UartError | None] | None:
        """Return what the wire makes of a byte of the host; `None` when it is lost."""
        self.counters["sent"] += 1
        if not self._is_whole(begun):
            return None
        if self.to_drop_sent:
            self.to_drop_sent -= 1
            self.counters["dropped"] += 1
            return None
        if self.to_spoil:
            return byte, self.to_spoil.popleft()
        return self._spoil(byte) if self._is_spoilt() else (byte, None)

    def _is_whole(self, begun: float) -> bool:
        """Whether the cable is in, and was when a byte began."""
        return self.plugged and begun >= self._plugged_at - _EPSILON

    def _echo(self, byte: int, end: float) -> None:
        """Let a byte of the host begin to come back."""
        if self.paced:
            self._shared.put(Frame(self.now, end, byte, *self._host_settings()))
        else:
            self.arrive(byte, self.now)

    def _host_settings(self) -> tuple[SerialFormat, int]:
        """Return how the host's port is set, as far as that is known, and its rate."""
        if self.host is not None:
            return self.host, self.host.baud
        memory = self.boards[0].memory
        return memory.line_settings, memory.baud

    # From the boards to the host

    @property
    def is_grounded(self) -> bool:
        """Whether a jumper holds SO to ground. Inferred: nothing reaches the host then."""
        return any(board.so_ground for board in self.boards)

    @property
    def is_instant(self) -> bool:
        """Whether bytes take no time and have nothing to collide with."""
        return not self.paced and len(self.boards) == 1

    def put(self, frame: Frame) -> None:
        """Let a byte of a board begin now."""
        if not self.is_grounded:
            self._shared.put(frame)

    def garble(self, byte: int) -> int:
        """Return what a host with other settings makes of a byte: never the byte itself."""
        self.counters["garbled"] += 1
        return byte ^ self._random.randrange(1, 256)

    def arrive(self, byte: int, begun: float) -> None:
        """Let a byte reach the host that began at a moment, if the wire lets it."""
        if self.mute or not self._is_whole(begun):
            return
        if self.to_drop:
            self.to_drop -= 1
            self.counters["dropped"] += 1
            return
        if self._is_spoilt():
            self.counters["spoilt"] += 1
            byte ^= 1 << self._random.randrange(8)
        self._received.append(byte)
        self.counters["received"] += 1

    # Faults

    def inject(self, data: bytes) -> None:
        """Put bytes on the wire to the host that no board has sent, behind those before."""
        byte_time = self._stations[0].byte_time
        for byte in data:
            start = max(self.now, self._injecting_until)
            self._injecting_until = start + byte_time
            self.at(start, partial(self._begin_injected, byte, start + byte_time))

    def _begin_injected(self, byte: int, end: float) -> None:
        if self.paced:
            self._shared.put(Frame(self.now, end, byte, *self._host_settings()))
        else:
            self.arrive(byte, self.now)

    def unplug(self) -> None:
        """Pull the cable: nothing passes until it is back in."""
        self.plugged = False
        self._received.clear()

    def plug(self) -> None:
        """Put the cable back in; of bytes that are under way nothing is whole."""
        if not self.plugged:
            self.plugged = True
            self._plugged_at = self.now

    def _is_spoilt(self) -> bool:
        return self.noise > 0 and self._random.random() < self.noise

    def _spoil(self, byte: int) -> tuple[int, UartError | None]:
        """Turn one bit round: a data bit, which parity notices, or the stop bit."""
        self.counters["spoilt"] += 1
        bit = self._random.randrange(9)
        if bit == 8:
            return byte, UartError.FRAMING
        return byte ^ 1 << bit, UartError.PARITY
