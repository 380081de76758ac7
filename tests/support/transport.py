"""Host side of a simulated line in virtual time."""

from collections.abc import Collection
from typing import Generic, TypeVar

from tests.support.guardian import VirtualGuardian
from trex_gui.core.simulator.line import SimulatedLine
from trex_gui.core.transport.settings import SerialFormat

LineT = TypeVar("LineT", bound=SimulatedLine)


class SimulatedTransport(Generic[LineT]):
    """Transport to a simulated device. Time passes only while the host reads or waits.

    Attributes:
        line: simulated line with its device.
        sent: all written bytes.
        written: time and bytes of each write.
        fail: exception that reads, writes and changes of the format raise, or `None`.
    """

    latency = 0.005
    is_configurable = True

    def __init__(self, line: LineT) -> None:
        self.line = line
        self.sent = bytearray()
        self.written: list[tuple[float, bytes]] = []
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
        self.written.append((self.clock(), data))
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
