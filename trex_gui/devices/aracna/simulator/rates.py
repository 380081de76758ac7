"""What the board and a host at another rate make of each other: other bytes, more or fewer."""

import math
from collections.abc import Callable, Iterable
from functools import partial

from trex_gui.core.simulator.sampling import Receiver, SampledByte
from trex_gui.core.simulator.timeline import Timeline
from trex_gui.core.transport.settings import Parity, SerialFormat

OWN = SerialFormat(38_400)
"""What a host has to be set to: 38400 8N1."""

REAL_BAUD = 16_000_000 / 16 / 26
"""The rate that the board's 16 MHz make of it, 38461.5 bit/s."""

_RATE_TOLERANCE = 0.03
"""How far two UARTs may be apart: half a bit in the ten of a byte, for both together."""


def is_other_rate(host: SerialFormat | None) -> bool:
    """Whether a host runs at a rate at which neither understands the other."""
    return host is not None and abs(host.baud / OWN.baud - 1) > _RATE_TOLERANCE


def is_other_parity(host: SerialFormat | None) -> bool:
    """Whether a host sends and wants a parity bit. A second stop bit harms nobody."""
    return host is not None and host.parity is not Parity.NONE


class Sampler:
    """A receiver at a rate of its own, with what its program gets.

    Neither the firmware nor a host's program looks at framing errors (assumed): they get
    whatever byte the levels give.
    """

    def __init__(
        self, timeline: Timeline, settings: SerialFormat, deliver: Callable[[int], None]
    ) -> None:
        self.settings = settings
        self._timeline = timeline
        self._deliver = deliver
        self._receiver = Receiver(settings, settings.baud, timeline.now)

    def hear(self, byte: int, sender: SerialFormat, *, paced: bool) -> None:
        """Take a byte that a sender with these settings begins now."""
        receiver, timeline = self._receiver, self._timeline
        if not paced:  # bytes take no time: each comes by itself
            self._pass_on(receiver.hear_alone(byte, sender, sender.baud))
            return
        for heard in receiver.hear(timeline.now, byte, sender, sender.baud):
            timeline.at(max(timeline.now, heard.at), partial(self._deliver, heard.value))
        if (due := receiver.due) is not None:
            timeline.at(due, partial(self._end, due))

    def _end(self, due: float) -> None:
        """Complete a byte behind which the sender has been silent."""
        self._pass_on(self._receiver.rest(math.nextafter(due, math.inf)))

    def _pass_on(self, heard: Iterable[SampledByte]) -> None:
        for each in heard:
            self._deliver(each.value)
