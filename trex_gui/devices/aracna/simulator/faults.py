"""What goes wrong with bytes on a wire: lost ones, turned bits, a line that is cut or mute."""

import math
import random
from collections import Counter

from trex_gui.core.simulator.timeline import EPSILON

_LINE_END = ord("\n")


class Faults:
    """The faults of one wire.

    Attributes:
        mute: whether nothing reaches the host.
        plugged: whether the cable is in.
        noise: probability that a byte is spoilt on its way.
        to_drop: how many of the next bytes to the host get lost.
        to_drop_sent: how many of the next bytes from the host get lost.
        to_cut: how many of the next bytes to the host still pass before the rest of a line is
            lost, its end too; `None` where no line is cut.
        counters: what the wire did.
    """

    def __init__(self, seed: int) -> None:
        self.mute = False
        self.plugged = True
        self.noise = 0.0
        self.to_drop = 0
        self.to_drop_sent = 0
        self.to_cut: int | None = None
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("sent", "received", "dropped", "spoilt", "garbled"), 0)
        )
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._plugged_at = -math.inf

    def plug(self, now: float) -> None:
        """Put the cable back in; of bytes that are under way nothing is whole."""
        if not self.plugged:
            self.plugged = True
            self._plugged_at = now

    def of_sent(self, byte: int, begun: float) -> int | None:
        """Return what the wire makes of a byte of the host; `None` when it is lost."""
        self.counters["sent"] += 1
        if not self._is_whole(begun):
            return None
        if self.to_drop_sent:
            self.to_drop_sent -= 1
            self.counters["dropped"] += 1
            return None
        return self._spoil(byte)

    def of_answered(self, byte: int, begun: float) -> int | None:
        """Return what the wire makes of a byte to the host; `None` when it is lost."""
        if self.mute or not self._is_whole(begun):
            return None
        if self.to_drop:
            self.to_drop -= 1
            self.counters["dropped"] += 1
            return None
        if self._is_cut_off(byte):
            self.counters["dropped"] += 1
            return None
        self.counters["received"] += 1
        return self._spoil(byte)

    def garble(self, byte: int) -> int:
        """Return what somebody with another parity makes of a byte: never the byte itself."""
        self.counters["garbled"] += 1
        return byte ^ self._random.randrange(1, 256)

    def _is_cut_off(self, byte: int) -> bool:
        """Whether a byte belongs to the rest of a line that is cut; its end ends the cut."""
        if self.to_cut is None:
            return False
        if self.to_cut:
            self.to_cut -= 1
            return False
        if byte == _LINE_END:
            self.to_cut = None
        return True

    def _is_whole(self, begun: float) -> bool:
        """Whether the cable is in, and was when a byte began."""
        return self.plugged and begun >= self._plugged_at - EPSILON

    def _spoil(self, byte: int) -> int:
        if self.noise <= 0 or self._random.random() >= self.noise:
            return byte
        self.counters["spoilt"] += 1
        return byte ^ 1 << self._random.randrange(8)
