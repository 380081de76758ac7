"""Schedule of the polled values.

Each value is polled as often as the board renews it. Polling faster reads the same value again and
takes time in which a motor command could have been sent.

While motors are armed, polling also feeds the board's serial timeout. The board counts from one
received byte to the next, and is deaf while it answers: the silence that it sees is the reply to
one query and the first byte of the next one.
"""

import math
from collections.abc import Collection, Mapping

from trex_gui.devices.trex.client.telemetry import POLLED, Control, Raw, Sample
from trex_gui.devices.trex.protocol.commands import Command
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey

SAFETY_PARAMETERS = (
    ParameterKey.SERIAL_TIMEOUT,
    MotorParameter.CURRENT_LIMIT.of(1),
    ParameterKey.UART_ERROR_SHUTDOWN,
    MotorParameter.CURRENT_LIMIT.of(2),
)
"""Parameters that decide how the board protects its motors. They are read continuously."""

Topic = type[Sample]  # a polled value, by the class of its samples

_LONGEST_LAG = 0.1  # seconds by which the schedule may be late before it stops catching up

_MARGIN = 0.015
"""Seconds between a reply and the next query: the board's response delay (1 ms), half of its 10 ms
cycle, and a busy host (some milliseconds, measured beside a window that paints)."""

_KEEPALIVE_SHARE = 0.4  # share of the serial timeout after which a topic is polled in any case

_CHEAPEST = Control  # polled to feed the serial timeout: one byte out, one byte in


def rates(source: InputSource, *, watched: bool = True) -> Mapping[Topic, float]:
    """Return the polls per second of each topic. If several are due, the first is polled."""
    is_analog = source is InputSource.ANALOG
    return {
        topic: (not watched and polled.unwatched)
        or (is_analog and polled.analog_rate)
        or polled.rate
        for topic, polled in sorted(POLLED.items(), key=lambda item: -item[1].rate)
    }


# --- The serial timeout -----------------------------------------------------------------


def silence(line: LineSettings, command: Command[object]) -> float:
    """Return the longest silence, in seconds, that a board sees around its reply to a query."""
    size = command.reply_size() + (line.detection is Detection.CRC7)
    return line.seconds(size + 1) + command.seconds_to_answer + _MARGIN


def too_slow(line: LineSettings, timeout: float) -> frozenset[Topic]:
    """Return the topics with replies that outlast a serial timeout (seconds, 0: off)."""
    if timeout <= 0:
        return frozenset()
    return frozenset(topic for topic in POLLED if silence(line, POLLED[topic].query) >= timeout)


def survives_a_loss(line: LineSettings, timeout: float, lateness: float) -> bool:
    """True if motors keep running when one reply is lost, since the next query comes in time.

    `lateness`: seconds for which a reply is awaited beyond its time on the wire.
    """
    left_out = too_slow(line, timeout)
    polled = [POLLED[topic].query for topic in POLLED if topic not in left_out]
    return timeout <= 0 or max(silence(line, query) for query in polled) + lateness < timeout


# --- The schedule -----------------------------------------------------------------------


class Schedule:
    """Times when topics are due. On a slow line each topic gets the same share of its rate."""

    def __init__(self) -> None:
        self._rates: Mapping[Topic, float] = {}
        self._due: dict[Topic, float] = {}

    def start(self, wanted: Mapping[Topic, float], now: float) -> None:
        """Poll each topic at its rate in `wanted`, from `now` on."""
        self._rates = wanted
        self._due = dict.fromkeys(wanted, now)

    def next(self, now: float) -> Topic | None:
        """Return the topic that was due first. `None` while no topic is due."""
        topic = min(self._due, key=self._due.__getitem__, default=None)
        return topic if topic is not None and self._due[topic] <= now else None

    def polled(self, topic: Topic, now: float) -> None:
        """Count a topic as polled.

        It is due again one period after it was due, so the rate is met on average. If the line
        falls behind, all topics are delayed by the same time, so that none starves.
        """
        if topic in self._due:
            self._due[topic] += 1 / self._rates[topic]
            behind = now - _LONGEST_LAG - min(self._due.values())
            if behind > 0:
                self._due = {each: due + behind for each, due in self._due.items()}

    def seconds_to_next(self, now: float) -> float:
        return max(0.0, min(self._due.values(), default=math.inf) - now)


class Polling:
    """The schedule of one board, and the keep-alive of its serial timeout."""

    def __init__(self) -> None:
        self._schedule = Schedule()
        self._source: InputSource | None = None
        self._watched = True
        self._polled_at = 0.0

    def start(self, source: InputSource, now: float) -> None:
        self._source = source
        self._schedule.start(rates(source, watched=self._watched), now)
        self._polled_at = now

    def set_watched(self, watched: bool, now: float) -> None:
        if watched != self._watched:
            self._watched = watched
            if self._source is not None:
                self.start(self._source, now)

    def next(
        self, now: float, line: LineSettings, timeout: float, *, careful: bool = False
    ) -> Topic | None:
        """Return the topic to poll now, and count it as polled. `None` while none is due.

        Polls keep the serial `timeout` (seconds, 0 for none) from expiring. `careful` omits queries
        that one damaged bit turns into a motor command.
        """
        left_out: Collection[Topic] = too_slow(line, timeout)
        if careful:
            left_out = {*left_out, Raw}  # 86 1F is one bit away from C6 1F, 87 1F brakes
        while topic := self._schedule.next(now):
            self._schedule.polled(topic, now)
            if topic not in left_out:
                break
        if topic is None and self._pause_left(now, timeout) == 0:
            topic = _CHEAPEST
        if topic is not None:
            self._polled_at = now
        return topic

    def seconds_to_next(self, now: float, timeout: float) -> float:
        return min(self._schedule.seconds_to_next(now), self._pause_left(now, timeout))

    def _pause_left(self, now: float, timeout: float) -> float:
        if timeout <= 0:
            return math.inf
        return max(0.0, self._polled_at + timeout * _KEEPALIVE_SHARE - now)
