"""What to ask next: each thing as often as the board renews it, in fair shares. Pure.

Asking faster than the board renews a value reads the same value again, and costs the time
in which a motor command could have gone out.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum, auto

from trex_gui.devices.trex.protocol.flags import InputSource

_LONGEST_LAG = 0.1
"""Seconds that the schedule may run behind before it gives up catching up."""


class Topic(Enum):
    """One thing that is asked again and again."""

    CURRENTS = auto()
    RAW = auto()
    REMAPPED = auto()
    STATUS = auto()
    CONTROL = auto()
    MODE = auto()


def rates(source: InputSource) -> Mapping[Topic, float]:
    """Return how often a second each topic is worth asking.

    Ref: command documentation 0x86 (inputs about 50 Hz), 0x8D (currents 50 Hz with analog,
    about 80 Hz with RC inputs). Status bits are latched, so nothing is missed between two
    looks; 10 Hz is as fast as a person reads. The mode only changes with the power.
    """
    return {
        Topic.CURRENTS: 80.0 if source is InputSource.RC else 50.0,
        Topic.RAW: 50.0,
        Topic.REMAPPED: 50.0,
        Topic.STATUS: 10.0,
        Topic.CONTROL: 10.0,
        Topic.MODE: 1.0,
    }


@dataclass(slots=True)
class _Entry:
    period: float
    due: float


@dataclass(slots=True)
class Schedule:
    """Remembers when each topic is due; knows no clock but the times it is given.

    Where the line is too slow for all of it, each topic gets the same share of its rate.
    """

    _entries: dict[Topic, _Entry] = field(default_factory=dict)

    def start(self, wanted: Mapping[Topic, float], now: float) -> None:
        """Ask for these topics, each so many times a second, from `now` on."""
        self._entries = {topic: _Entry(1 / rate, now) for topic, rate in wanted.items()}

    def clear(self) -> None:
        """Ask for nothing."""
        self._entries = {}

    def next(self, now: float) -> Topic | None:
        """Return the topic that was due first; `None` while none is."""
        topic = min(self._entries, key=lambda topic: self._entries[topic].due, default=None)
        return topic if topic is not None and self._entries[topic].due <= now else None

    def asked(self, topic: Topic, now: float) -> None:
        """Note that a topic was asked at `now`.

        It is due again one period after it was due, so the rate is met on average. Where the
        line falls behind, everything is put off by the same time, so nothing is made up for
        and nothing starves.
        """
        if entry := self._entries.get(topic):
            entry.due += entry.period
            behind = now - _LONGEST_LAG - min(entry.due for entry in self._entries.values())
            if behind > 0:
                for each in self._entries.values():
                    each.due += behind

    def seconds_to_next(self, now: float) -> float | None:
        """Return how long nothing is due; `None` when nothing ever is."""
        if not self._entries:
            return None
        return max(0.0, min(entry.due for entry in self._entries.values()) - now)
