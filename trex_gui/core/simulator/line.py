"""Serial line between a host and simulated devices, with faults.

Time is virtual. Bytes take as long as on a real wire, but no function waits. `advance` processes
the events of the wire and the devices.
"""

import math
import random
from collections import Counter, deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Protocol

from trex_gui.core.simulator.sampling import (
    ReceiveError,
    Receiver,
    SampledByte,
    levels,
    rates_differ,
)
from trex_gui.core.simulator.timeline import EPSILON, Timeline
from trex_gui.core.transport.settings import SerialFormat

_LINE_END = ord("\n")


class WireFaults:
    def __init__(self, seed: int, noisy_bits: int) -> None:
        """`noisy_bits`: 8 for noise on the data bits, 9 for noise also on the stop bit."""
        self.mute = False  # True while no byte reaches the host
        self.plugged = True
        self.noise = 0.0  # probability that a byte is corrupted
        self.delay = 0.0  # delay of bytes to the host in seconds
        self.to_drop = self.to_drop_sent = 0  # upcoming bytes to lose, to and from the host
        self.to_corrupt = self.to_double = 0  # upcoming bytes to the host to corrupt or double
        self.to_cut: int | None = None  # bytes to the host until a text line is cut off
        self.errors: deque[ReceiveError] = deque()  # errors of the upcoming bytes from the host
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("sent", "received", "dropped", "corrupted", "garbled", "collisions"), 0)
        )
        self._noisy_bits = noisy_bits
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._plugged_at = -math.inf

    def plug(self, now: float) -> None:
        if not self.plugged:
            self.plugged = True
            self._plugged_at = now

    def on_way_to_device(self, byte: int, begun: float) -> tuple[int, ReceiveError | None] | None:
        self.counters["sent"] += 1
        if not self._is_whole(begun):
            return None
        if self.to_drop_sent:
            self.to_drop_sent -= 1
            self.counters["dropped"] += 1
            return None
        if self.errors:
            return byte, self.errors.popleft()
        if not self._is_noisy():
            return byte, None
        bit = self._random.randrange(self._noisy_bits)
        if bit == 8:
            return byte, ReceiveError.FRAMING
        return byte ^ 1 << bit, ReceiveError.PARITY

    def on_way_to_host(self, byte: int, begun: float) -> bytes:
        """Return the bytes that arrive at the host: none, one or two."""
        if self.mute or not self._is_whole(begun):
            return b""
        if self.to_drop:
            self.to_drop -= 1
            self.counters["dropped"] += 1
            return b""
        if self.to_cut is not None and self._is_cut_off(byte):
            self.counters["dropped"] += 1
            return b""
        self.counters["received"] += 1
        if self._is_noisy():
            byte ^= 1 << self._random.randrange(8)
        elif self.to_corrupt:
            self.to_corrupt -= 1
            self.counters["corrupted"] += 1
            byte ^= 1 << self._random.randrange(8)
        if self.to_double:
            self.to_double -= 1
            return bytes((byte, byte))
        return bytes((byte,))

    def garble(self, byte: int) -> int:
        self.counters["garbled"] += 1
        return byte ^ self._random.randrange(1, 256)

    def _is_noisy(self) -> bool:
        if self.noise <= 0 or self._random.random() >= self.noise:
            return False
        self.counters["corrupted"] += 1
        return True

    def _is_cut_off(self, byte: int) -> bool:
        if self.to_cut:
            self.to_cut -= 1
            return False
        if byte == _LINE_END:
            self.to_cut = None
        return True

    def _is_whole(self, begun: float) -> bool:
        """Return whether the cable has been plugged in since `begun`."""
        return self.plugged and begun >= self._plugged_at - EPSILON


class Station(Protocol):
    """UART of a device on the line. `baud`: real bit rate."""

    @property
    def line_format(self) -> SerialFormat: ...
    @property
    def baud(self) -> float: ...

    def advance(self, seconds: float) -> None: ...

    def receive(
        self, byte: int, host: SerialFormat | None, error: ReceiveError | None, begun: float
    ) -> None:
        """Receive a byte sent at the station's rate. `begun`: start time of the byte (s)."""

    def sample(self, byte: int, host: SerialFormat) -> None:
        """Sample a byte that starts now at another rate."""


@dataclass(slots=True, eq=False)
class _Frame:
    """Byte in transit to the host from `start` to `end` (s).

    `baud`: real bit rate. If the sender loses power before the end, `is_alive` returns False.
    The byte is then lost, and `then` is not called.
    """

    start: float
    end: float
    value: int
    sender: SerialFormat
    baud: float
    is_alive: Callable[[], bool]
    then: Callable[[], object] = lambda: None
    collided: bool = False

    def coincides_with(self, other: "_Frame") -> bool:
        return (
            abs(self.start - other.start) < EPSILON
            and abs(self.end - other.end) < EPSILON
            and self.baud == other.baud
        )

    def level(self, moment: float) -> int:
        index = int((moment - self.start) * self.baud)
        bits = levels(self.value, self.sender)
        return bits[index] if 0 <= index < len(bits) and moment >= self.start else 1


class SimulatedLine:
    """Wire between a host and its stations.

    The outputs of the stations, the echo and injected garbage are ANDed, as on a real wire. Bytes
    that start together arrive as their AND. If bytes overlap in another way, the host samples the
    level of the wire.

    Attributes:
        host: settings of the host's port. `None`: the settings of the first station.
    """

    stations: Sequence[Station]

    def __init__(
        self, *, echo: bool = False, paced: bool = True, seed: int = 0, noisy_bits: int = 8
    ) -> None:
        self.echo = echo  # True if bytes from the host return to it, as on an RS-232 connector
        self.paced = paced  # True if bytes take as long as on a real wire
        self.host: SerialFormat | None = None
        self.faults = WireFaults(seed, noisy_bits)
        self.timeline = Timeline(self._advance_stations)
        self._received = bytearray()
        self._delayed_until = 0.0
        self._host_busy_until = 0.0
        self._queue_number = 0
        self._injecting_until = 0.0
        self._frames: list[_Frame] = []
        self._collided: list[_Frame] = []

    @property
    def host_format(self) -> SerialFormat:
        return self.stations[0].line_format

    @property
    def save_errors(self) -> Sequence[str]:
        """Reasons why the memory of a device could not be saved."""
        return ()

    # --- Host ---------------------------------------------------------------------------

    def send(self, data: bytes) -> None:
        host, at = self.host, self.timeline.at
        is_sampled = host is not None and any(
            rates_differ(host.baud, station.baud) for station in self.stations
        )
        byte_time = host.seconds(1) if host is not None and self.paced else self.byte_time
        is_current = partial(self._is_current_queue, self._queue_number)
        for byte in data:
            start = max(self.now, self._host_busy_until)
            end = self._host_busy_until = start + byte_time
            if self.echo:
                at(start, partial(self._put_at_host_rate, byte, end), is_current)
            if is_sampled and host is not None:
                at(start, partial(self._start_other_rate, byte, host, end, is_current), is_current)
            else:
                at(end, partial(self._deliver, byte, host, start), is_current)

    def drop_unsent(self) -> None:
        """Discard queued bytes after the host has closed or reconfigured its port."""
        self._queue_number += 1
        self._host_busy_until = self.now

    def receive(self) -> bytes:
        data = bytes(self._received)
        self._received.clear()
        return data

    def read(self, size: int, seconds: float) -> bytes:
        end = self.now + seconds
        if not self.run_until_received(size, end):
            self.timeline.move_to(end)
        data = bytes(self._received[:size])
        del self._received[:size]
        return data

    def run_until_received(self, size: int, end: float) -> bool:
        """Run actions until `end` or until `size` bytes are received. Return whether they are."""
        while len(self._received) < size and self.timeline.step(end):
            pass
        return len(self._received) >= size

    @property
    def backlog(self) -> float:
        """Seconds until all queued bytes from the host are sent."""
        return max(0.0, self._host_busy_until - self.now)

    def _is_current_queue(self, number: int) -> bool:
        return number == self._queue_number

    # --- Time ---------------------------------------------------------------------------

    @property
    def now(self) -> float:
        return self.timeline.now

    @property
    def next_event(self) -> float | None:
        return self.timeline.next_event

    def advance(self, seconds: float) -> None:
        self.advance_to(self.now + seconds)

    def advance_to(self, moment: float) -> None:
        while self.timeline.step(moment):
            pass
        self.timeline.move_to(moment)

    def _advance_stations(self, seconds: float) -> None:
        for station in self.stations:
            station.advance(seconds)

    # --- From the host to the stations --------------------------------------------------

    def _deliver(self, byte: int, host: SerialFormat | None, begun: float) -> None:
        if (arriving := self.faults.on_way_to_device(byte, begun)) is not None:
            for station in self.stations:
                station.receive(arriving[0], host, arriving[1], begun)

    def _start_other_rate(
        self, byte: int, host: SerialFormat, end: float, is_current: Callable[[], bool]
    ) -> None:
        if (arriving := self.faults.on_way_to_device(byte, self.now)) is None:
            return
        byte, error = arriving
        for station in self.stations:
            if rates_differ(host.baud, station.baud):
                station.sample(byte, host)
            else:
                receive = partial(station.receive, byte, host, error, self.now)
                self.timeline.at(end, receive, is_current)

    # --- To the host --------------------------------------------------------------------

    @property
    def byte_time(self) -> float:
        return self.byte_time_of(self.stations[0])

    def byte_time_of(self, station: Station) -> float:
        return station.line_format.bits_per_byte / station.baud if self.paced else 0.0

    def transmit(
        self,
        byte: int,
        station: Station,
        is_alive: Callable[[], bool],
        then: Callable[[], object] = lambda: None,
    ) -> None:
        """Send a byte from a station, then call `then`.

        If `is_alive` returns False at the end of the byte, the byte is lost and `then` is not
        called.
        """
        now, end = self.now, self.now + self.byte_time_of(station)
        self._put(_Frame(now, end, byte, station.line_format, station.baud, is_alive, then))

    def arrive(self, byte: int, begun: float) -> None:
        arriving = self.faults.on_way_to_host(byte, begun)
        self._delayed_until = max(self._delayed_until, self.now + self.faults.delay)
        if self._delayed_until > self.now:
            deliver = partial(self._received.extend, arriving)
            self.timeline.at(self._delayed_until, deliver, lambda: self.faults.plugged)
        else:
            self._received += arriving

    def inject(self, data: bytes) -> None:
        """Send garbage bytes to the host."""
        byte_time = self.byte_time
        for byte in data:
            start = max(self.now, self._injecting_until)
            end = self._injecting_until = start + byte_time
            self.timeline.at(start, partial(self._put_at_host_rate, byte, end))

    def unplug(self) -> None:
        self.faults.plugged = False
        self._received.clear()

    def plug(self) -> None:
        self.faults.plug(self.now)

    def _host_receiver(self) -> tuple[SerialFormat, float]:
        if self.host is not None:
            return self.host, self.host.baud
        return self.stations[0].line_format, self.stations[0].baud

    def _put_at_host_rate(self, byte: int, end: float) -> None:
        if self.paced:
            self._put(_Frame(self.now, end, byte, *self._host_receiver(), lambda: True))
        else:
            self.arrive(byte, self.now)

    def _put(self, frame: _Frame) -> None:
        others = [
            other
            for other in self._frames
            if other.is_alive()
            and (other.end > frame.start + EPSILON or frame.coincides_with(other))
        ]
        if others:
            self.faults.counters["collisions"] += 1
            if len(others) == 1 and not others[0].collided and frame.coincides_with(others[0]):
                others[0].value &= frame.value
                self.timeline.at(frame.end, frame.then, frame.is_alive)
                return
            for overlapping in (*others, frame):
                if not overlapping.collided:
                    overlapping.collided = True
                    self._collided.append(overlapping)
        self._frames.append(frame)
        self.timeline.at(frame.end, partial(self._end, frame))

    def _end(self, frame: _Frame) -> None:
        self._frames.remove(frame)
        is_alive = frame.is_alive()
        if not frame.collided:
            if is_alive:
                self.arrive(frame.value, frame.start)
        elif not any(other.collided for other in self._frames):
            collided, self._collided = self._collided, []
            self._resolve([other for other in collided if other.is_alive()])
        if is_alive:
            frame.then()

    def _resolve(self, frames: Sequence[_Frame]) -> None:
        if not frames:
            return
        start = min(frame.start for frame in frames)
        edges = sorted(
            {
                frame.start + bit / frame.baud
                for frame in frames
                for bit in range(frame.sender.bits_per_byte + 1)
            }
        )
        receiver = Receiver(*self._host_receiver(), start)
        sampled: list[SampledByte] = []
        for before, after in pairwise(edges):
            middle = (before + after) / 2
            sampled += receiver.sample(min(frame.level(middle) for frame in frames), after)
        sampled += receiver.idle(edges[-1] + 20 / receiver.baud)
        for sampled_byte in sampled:
            self.arrive(sampled_byte.value, start)
