"""The wire to the host, on which several may talk at once: boards, echo, noise from nowhere.

Their outputs are ANDed, as they must be on a real wire. Bytes that begin together arrive as the
AND of them; of bytes that overlap otherwise the host samples what the levels make.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from trex_gui.core.simulator.sampling import Receiver, SampledByte, levels
from trex_gui.core.transport.settings import SerialFormat

_EPSILON = 1e-9  # seconds; swallows the rounding of summed times


@dataclass(slots=True, eq=False)
class Frame:
    """A byte on its way to the host.

    Attributes:
        start, end: when it begins and ends, in seconds.
        value: the byte.
        settings, baud: how its sender is set.
        alive: whether the sender has not died meanwhile.
        clashed: whether others talked into it.
    """

    start: float
    end: float
    value: int
    settings: SerialFormat
    baud: int
    alive: Callable[[], bool] = lambda: True
    clashed: bool = False

    def is_in_step_with(self, other: "Frame") -> bool:
        """Whether it begins and ends with another."""
        return (
            abs(self.start - other.start) < _EPSILON
            and abs(self.end - other.end) < _EPSILON
            and self.baud == other.baud
        )

    def level(self, moment: float) -> int:
        """Return what its sender puts on the wire at a moment: low in a start bit, else high."""
        index = int((moment - self.start) * self.baud)
        bits = levels(self.value, self.settings)
        return bits[index] if 0 <= index < len(bits) and moment >= self.start else 1


class SharedWire:
    """Tells who talks at the moment, and what the host gets of it."""

    def __init__(
        self,
        at: Callable[[float, Callable[[], None]], None],
        arrive: Callable[[int, float], None],
        host: Callable[[], tuple[SerialFormat, int]],
        counters: Counter[str],
    ) -> None:
        """Make a wire of which nobody talks.

        Args:
            at: does something at a moment.
            arrive: gives the host a byte that began at a moment.
            host: how the host's receiver is set.
            counters: where bytes that were talked into are counted as `collisions`.
        """
        self._counters = counters
        self._at = at
        self._arrive = arrive
        self._host = host
        self._talking: list[Frame] = []
        self._clash: list[Frame] = []

    def put(self, frame: Frame) -> None:
        """Let a byte begin now."""
        others = [
            other
            for other in self._talking
            if other.end > frame.start + _EPSILON or frame.is_in_step_with(other)
        ]
        if others:
            self._counters["collisions"] += 1
            if len(others) == 1 and not others[0].clashed and frame.is_in_step_with(others[0]):
                others[0].value &= frame.value
                return
            for each in (*others, frame):
                if not each.clashed:
                    each.clashed = True
                    self._clash.append(each)
        self._talking.append(frame)
        self._at(frame.end, lambda: self._end(frame))

    def _end(self, frame: Frame) -> None:
        self._talking.remove(frame)
        if not frame.clashed:
            if frame.alive():
                self._arrive(frame.value, frame.start)
        elif not any(other.clashed for other in self._talking):
            clash, self._clash = self._clash, []
            self._resolve([each for each in clash if each.alive()])

    def _resolve(self, clash: list[Frame]) -> None:
        """Give the host what it makes of bytes that were talked into each other."""
        if not clash:
            return
        begin = min(frame.start for frame in clash)
        edges = sorted(
            {
                frame.start + bit / frame.baud
                for frame in clash
                for bit in range(frame.settings.bits_per_byte + 1)
            }
        )
        receiver = Receiver(*self._host(), begin)
        heard: list[SampledByte] = []
        for before, after in pairwise(edges):
            middle = (before + after) / 2
            level = min(frame.level(middle) for frame in clash)
            heard += receiver.take(level, after)
        heard += receiver.rest(edges[-1] + 20 / receiver.baud)
        for each in heard:
            self._arrive(each.value, begin)
