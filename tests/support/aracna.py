"""A simulated Aracna, as a process of its own and in virtual time."""

from collections.abc import Collection
from typing import Any

from tests.support.guardian import VirtualGuardian
from tests.support.simulator import SimulatorProcess
from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.aracna.simulator.control import control
from trex_gui.devices.aracna.simulator.line import AracnaLine

BOOT = 1.1
"""Seconds after which a board that was switched on listens."""


class AracnaProcess(SimulatorProcess):
    """`trex-sim --aracna` in a process of its own, and its control line."""

    def __init__(self, *arguments: str) -> None:
        super().__init__("--aracna", *arguments)


class AracnaTransport:
    """The host's end of a simulated wire; time passes only while somebody reads or waits.

    Attributes:
        line: the wire, and the robot at its other end.
        sent: all that was written.
        closed: whether it was closed.
        fail: what every access raises; `None` while the line is there.
    """

    latency = 0.005
    is_configurable = True

    def __init__(self, line: AracnaLine) -> None:
        self.line = line
        self.sent = bytearray()
        self.closed = False
        self.fail: Exception | None = None

    def clock(self) -> float:
        return self.line.now

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        return None

    def reconfigure(self, line: SerialFormat) -> None:
        self._may_fail()
        self.line.host = line

    def write(self, data: bytes) -> None:
        self._may_fail()
        self.sent += data
        self.line.send(data)

    def read(self, size: int, seconds: float) -> bytes:
        self._may_fail()
        return self.line.read(size, seconds)

    def discard(self) -> bytes:
        return self.line.receive()

    def wait(self, seconds: float) -> None:
        if seconds > 0:
            self.line.advance(seconds)

    def start_guardian(self, silence: float) -> VirtualGuardian:
        self.guardian = VirtualGuardian()
        return self.guardian

    def close(self) -> None:
        self.closed = True

    def _may_fail(self) -> None:
        if self.fail:
            raise self.fail


class AracnaStage:
    """A robot and its wire in virtual time.

    `options` are `AracnaLine`'s: `motors`, `positions`, `margin`, `boot_loader` …
    `stage.line.servos[3].alive = False` and `stage.do("servo 3 dead")` do the same.
    """

    def __init__(self, *, booted: bool = True, **options: Any) -> None:
        self.line = AracnaLine(**options)
        self.transport = AracnaTransport(self.line)
        if booted:
            self.line.advance(BOOT + options.get("boot_loader", 0.0))
            self.line.receive()

    @property
    def now(self) -> float:
        """Virtual seconds since the robot was switched on."""
        return self.line.now

    @property
    def positions(self) -> tuple[int, ...]:
        """Where the servos are."""
        return tuple(round(servo.position) for servo in self.line.servos)

    @property
    def goals(self) -> tuple[int, ...]:
        """The last goals that they accepted."""
        return tuple(servo.goal for servo in self.line.servos)

    @property
    def speeds(self) -> tuple[int, ...]:
        """The speeds that they hold."""
        return tuple(servo.speed for servo in self.line.servos)

    def do(self, line: str) -> str:
        """Obey a control line; return what follows `ok`."""
        answer = control(self.line, line)
        assert answer.startswith("ok"), f"{line}: {answer}"
        return answer.removeprefix("ok").strip()

    def ask(self, line: bytes, seconds: float = 5.0) -> bytes:
        """Send bytes, let time pass, return all that came."""
        self.line.send(line)
        self.line.advance(seconds)
        return self.line.receive()
