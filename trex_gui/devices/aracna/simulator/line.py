"""The wire between a host and a simulated Aracna, in virtual time.

Bytes take as long as they take and servos as long as they need; nothing here waits. `advance`
moves board, servos and wire forward together, event by event.
"""

from collections.abc import Callable, Sequence
from functools import partial

from trex_gui.core.simulator.timeline import Timeline
from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.aracna.protocol.units import MOTORS
from trex_gui.devices.aracna.simulator.faults import Faults
from trex_gui.devices.aracna.simulator.firmware import Firmware
from trex_gui.devices.aracna.simulator.rates import (
    OWN,
    REAL_BAUD,
    Sampler,
    is_other_parity,
    is_other_rate,
)
from trex_gui.devices.aracna.simulator.servos import MARGIN, Servo
from trex_gui.devices.aracna.simulator.station import RobotOnWire

_OLD_MOTORS = 2
"""Motors of version 0, of 22 Sep 2012."""


class AracnaLine:
    """One robot with its wire; it has just been switched on.

    Attributes:
        servos: motor 0 first.
        station: the board.
        faults: what the wire does to bytes.
        paced: whether bytes take their time on the wire; servos and booting always do.
        host: what the host has set its port to; `None` assumes that it fits.
    """

    def __init__(
        self,
        motors: int = MOTORS,
        *,
        paced: bool = True,
        seed: int = 0,
        version: int | None = None,
        positions: Sequence[int] | None = None,
        margin: int = MARGIN,
        tells_motors: bool = True,
        boot_loader: float = 0.0,
        keeps_last: bool = True,
    ) -> None:
        """Switch a robot on.

        Args:
            motors: how many it has.
            paced: whether bytes take their time on the wire.
            seed: for the noise.
            version: of the firmware; `None` is 0 with two motors and else 1.
            positions: where the servos are, 0-1023; `None` is the centre, all of them.
            margin: units off its goal at which a servo is content.
            tells_motors: whether `.q` says how many motors there are.
            boot_loader: seconds before each `.h`.
            keeps_last: see `uart.Holding`.
        """
        if positions is None:
            positions = (512,) * motors
        if motors < 1 or len(positions) != motors:
            raise ValueError(f"{motors} motors and {len(positions)} positions")
        if version is None:
            version = 0 if motors == _OLD_MOTORS else 1
        self.servos = tuple(Servo(position, margin) for position in positions)
        self.paced = paced
        self.host: SerialFormat | None = None
        self.faults = Faults(seed)
        firmware = Firmware(
            self.servos, version, tells_motors=tells_motors, boot_loader=boot_loader
        )
        self._timeline = Timeline(self._pass)
        self._ear = Sampler(self._timeline, OWN, self._hear_sampled)
        self._mouth: Sampler | None = None
        self._received = bytearray()
        self._host_busy_until = 0.0
        self._host_turn = 0
        self._injecting_until = 0.0
        self.station = RobotOnWire(firmware, self, keeps_last=keeps_last)
        self.station.power_on()

    # The host's end

    def send(self, data: bytes) -> None:
        """Queue bytes that the host sends now."""
        host = self.host
        byte_time = self._host_byte_time
        for byte in data:
            start = max(self.now, self._host_busy_until)
            self._host_busy_until = start + byte_time
            if host is not None and is_other_rate(host):
                self._while_wanted(start, partial(self._begin_alien, byte, host))
            else:
                end = self._host_busy_until
                self._while_wanted(end, partial(self._hear, byte, host, start))

    def drop_unsent(self) -> None:
        """Forget what the host has queued: its port was closed, or set anew."""
        self._host_turn += 1
        self._host_busy_until = self.now

    def receive(self) -> bytes:
        """Take what has reached the host so far."""
        data = bytes(self._received)
        self._received.clear()
        return data

    def read(self, size: int, seconds: float) -> bytes:
        """Let time pass until `size` bytes have come or `seconds` are over; return them."""
        end = self.now + seconds
        while len(self._received) < size and self._timeline.step(end):
            pass
        if len(self._received) < size:
            self._timeline.move_to(end)
        data = bytes(self._received[:size])
        del self._received[:size]
        return data

    @property
    def own_settings(self) -> SerialFormat:
        """What a host that fits has set its port to: 38400 8N1."""
        return OWN

    @property
    def unsaved(self) -> tuple[str, ...]:
        """Why something is not in a file: nothing should be."""
        return ()

    @property
    def backlog(self) -> float:
        """Seconds that the bytes which the host has queued still need to get onto the wire."""
        return max(0.0, self._host_busy_until - self.now)

    # Time

    @property
    def now(self) -> float:
        """Seconds since the robot was switched on."""
        return self._timeline.now

    @property
    def next_event(self) -> float | None:
        """When something happens on board or wire next, if anything is under way."""
        return self._timeline.next_event

    def at(self, moment: float, action: Callable[[], None]) -> None:
        """Do something when a moment has come."""
        self._timeline.at(moment, action)

    def advance(self, seconds: float) -> None:
        """Let time pass."""
        self.advance_to(self.now + seconds)

    def advance_to(self, moment: float) -> None:
        """Let time pass until a moment; one that is over already changes nothing."""
        while self._timeline.step(moment):
            pass
        self._timeline.move_to(moment)

    def _pass(self, seconds: float) -> None:
        for servo in self.servos:
            servo.advance(seconds)

    # From the host to the board

    @property
    def _host_byte_time(self) -> float:
        if not self.paced:
            return 0.0
        return self.byte_time if self.host is None else self.host.seconds(1)

    def _while_wanted(self, moment: float, action: Callable[[], None]) -> None:
        """Do something for the host at a moment, unless what it had queued is dropped before."""
        turn = self._host_turn

        def act() -> None:
            if turn == self._host_turn:
                action()

        self.at(moment, act)

    def _hear(self, byte: int, host: SerialFormat | None, begun: float) -> None:
        """Let a byte of the host arrive."""
        heard = self.faults.of_sent(byte, begun)
        if heard is not None:
            self.station.hear(self.faults.garble(heard) if is_other_parity(host) else heard)

    def _begin_alien(self, byte: int, host: SerialFormat) -> None:
        """Let a byte of a host at another rate begin."""
        heard = self.faults.of_sent(byte, self.now)
        if heard is not None:
            self._ear.hear(heard, host, paced=self.paced)

    def _hear_sampled(self, byte: int) -> None:
        self.faults.counters["garbled"] += 1
        self.station.hear(byte)

    # From the board to the host

    @property
    def byte_time(self) -> float:
        """Seconds that a byte of the board takes."""
        return OWN.bits_per_byte / REAL_BAUD if self.paced else 0.0

    def carry(self, byte: int, is_whole: Callable[[], bool]) -> None:
        """Let a byte of the board begin now; it arrives if `is_whole` at its end."""
        host, begun = self.host, self.now
        if host is not None and is_other_rate(host):
            if self._mouth is None or self._mouth.settings != host:
                self._mouth = Sampler(self._timeline, host, self._arrive_sampled)
            self._mouth.hear(byte, OWN, paced=self.paced)
            return
        if is_other_parity(host):
            byte = self.faults.garble(byte)

        def end() -> None:
            if is_whole():
                self._arrive(byte, begun)

        self.at(begun + self.byte_time, end)

    def _arrive_sampled(self, byte: int) -> None:
        self.faults.counters["garbled"] += 1
        self._arrive(byte, self.now)

    def _arrive(self, byte: int, begun: float) -> None:
        arrived = self.faults.of_answered(byte, begun)
        if arrived is not None:
            self._received.append(arrived)

    # The cable

    def inject(self, data: bytes) -> None:
        """Put bytes on the wire to the host that no board has sent."""
        for byte in data:
            start = max(self.now, self._injecting_until)
            self._injecting_until = start + self.byte_time
            self.at(self._injecting_until, partial(self._arrive, byte, start))

    @property
    def plugged(self) -> bool:
        """Whether the cable is in."""
        return self.faults.plugged

    def unplug(self) -> None:
        """Pull the cable: nothing passes until it is back in."""
        self.faults.plugged = False
        self._received.clear()

    def plug(self) -> None:
        """Put the cable back in; of bytes that are under way nothing is whole."""
        self.faults.plug(self.now)
