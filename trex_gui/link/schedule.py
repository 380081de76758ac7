"""What to ask next: each thing as often as the board renews it, in fair shares. Pure.

Asking faster than the board renews a value reads the same value again, and costs the time
in which a motor command could have gone out.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto

from trex_gui.protocol.flags import InputSource


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

    Where the line is too slow for all of it, each topic falls behind by the same share of
    its period.
    """

    _entries: dict[Topic, _Entry] = field(default_factory=dict)

    def start(self, wanted: Mapping[Topic, float], now: float) -> None:
        """Ask for these topics, each so many times a second, from `now` on."""
        self._entries = {topic: _Entry(1 / rate, now) for topic, rate in wanted.items()}

    def clear(self) -> None:
        """Ask for nothing."""
        self._entries = {}

    def hurry(self, topics: Iterable[Topic], now: float) -> None:
        """Ask for these topics next."""
        for topic in topics:
            if entry := self._entries.get(topic):
                entry.due = min(entry.due, now - entry.period)

    def next(self, now: float) -> Topic | None:
        """Return the topic that is most overdue, measured in its own periods."""
        chosen: Topic | None = None
        worst = 0.0
        for topic, entry in self._entries.items():
            late = (now - entry.due) / entry.period
            if late >= worst and (chosen is None or late > worst):
                chosen, worst = topic, late
        return chosen

    def asked(self, topic: Topic, now: float) -> None:
        """Note that a topic was asked at `now`.

        It is due again one period after it was due, so the rate is met on average, but what
        was missed is not made up for.
        """
        if entry := self._entries.get(topic):
            entry.due = max(entry.due + entry.period, now)

    def seconds_to_next(self, now: float) -> float | None:
        """Return how long nothing is due; `None` when nothing ever is."""
        if not self._entries:
            return None
        return max(0.0, min(entry.due for entry in self._entries.values()) - now)
