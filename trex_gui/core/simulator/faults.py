"""Faults of a wire: lost and corrupted bytes, cut lines, a cable that is mute or unplugged."""

import math
import random
from collections import Counter, deque

from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.core.simulator.timeline import EPSILON

_LINE_END = ord("\n")


class WireFaults:
    """Faults of a wire, and counters of the bytes on it.

    Attributes:
        mute: whether nothing reaches the host.
        plugged: whether the cable is plugged in.
        noise: probability that a byte is corrupted.
        to_drop, to_drop_sent: number of bytes to lose next, to and from the host.
        to_cut: number of bytes to the host after which the rest of a text line is lost, its
            end included; `None` for no cut.
        errors: errors with which the next bytes from the host reach the device.
    """

    def __init__(self, seed: int, noisy_bits: int) -> None:
        """`noisy_bits` is 8 when noise affects data bits, 9 when the stop bit as well."""
        self.mute = False
        self.plugged = True
        self.noise = 0.0
        self.to_drop = 0
        self.to_drop_sent = 0
        self.to_cut: int | None = None
        self.errors: deque[ReceiveError] = deque()
        self.counters: Counter[str] = Counter(
            dict.fromkeys(("sent", "received", "dropped", "corrupted", "garbled", "collisions"), 0)
        )
        self._noisy_bits = noisy_bits
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._plugged_at = -math.inf

    def plug(self, now: float) -> None:
        """Plug the cable in; bytes under way are lost."""
        if not self.plugged:
            self.plugged = True
            self._plugged_at = now

    def on_way_to_device(self, byte: int, begun: float) -> tuple[int, ReceiveError | None] | None:
        """Return a byte from the host as it arrives; `None` if it is lost."""
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

    def on_way_to_host(self, byte: int, begun: float) -> int | None:
        """Return a byte to the host as it arrives; `None` if it is lost."""
        if self.mute or not self._is_whole(begun):
            return None
        if self.to_drop:
            self.to_drop -= 1
            self.counters["dropped"] += 1
            return None
        if self.to_cut is not None and self._is_cut_off(byte):
            self.counters["dropped"] += 1
            return None
        self.counters["received"] += 1
        return byte ^ 1 << self._random.randrange(8) if self._is_noisy() else byte

    def garble(self, byte: int) -> int:
        """Return another byte than the one sent, as a receiver with other parity gets."""
        self.counters["garbled"] += 1
        return byte ^ self._random.randrange(1, 256)

    def _is_noisy(self) -> bool:
        if self.noise <= 0 or self._random.random() >= self.noise:
            return False
        self.counters["corrupted"] += 1
        return True

    def _is_cut_off(self, byte: int) -> bool:
        """Whether a byte belongs to a cut; the end of the text line ends the cut."""
        if self.to_cut:
            self.to_cut -= 1
            return False
        if byte == _LINE_END:
            self.to_cut = None
        return True

    def _is_whole(self, begun: float) -> bool:
        """Whether the cable has been plugged in since a byte began."""
        return self.plugged and begun >= self._plugged_at - EPSILON
