"""Schedule of the polled values.

Each value is polled as often as the board updates it. Faster polling would read old values and
delay motor commands.

While motors are armed, polling also prevents the board's serial timeout. The board measures the
time between received bytes (inferred; the twin measures it between valid packets), and cannot
receive while it replies. Therefore, the longest silence includes a reply and the first byte of the
next query.
"""

import math
from collections.abc import Collection, Mapping

from trex_gui.devices.trex.client.telemetry import POLLED, Control, Raw, Sample
from trex_gui.devices.trex.protocol.commands import Command
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey

SAFETY_PARAMETERS = (  # read continuously, because they protect the motors
    ParameterKey.SERIAL_TIMEOUT,
    MotorParameter.CURRENT_LIMIT.of(1),
    ParameterKey.UART_ERROR_SHUTDOWN,
    MotorParameter.CURRENT_LIMIT.of(2),
)

Topic = type[Sample]  # class of a polled value

_MAXIMUM_LAG = 0.1  # seconds; a schedule does not make up for a longer lag

# Sum of the board's response delay (1 ms), half of its 10 ms cycle and the host's delay (a few
# milliseconds, measured while a window is painted).
_MARGIN = 0.015  # longest time between a reply and the next query, in seconds

_KEEPALIVE_FRACTION = 0.4  # fraction of the serial timeout after which a poll is due

_CHEAPEST = Control  # shortest transaction: one byte out, one byte in


def rates(source: InputSource, *, watched: bool = True) -> Mapping[Topic, float]:
    """Return the polls per second for each topic, in descending order of `PolledValue.rate`."""
    is_analog = source is InputSource.ANALOG
    return {
        topic: (not watched and polled.unwatched_rate)
        or (is_analog and polled.analog_rate)
        or polled.rate
        for topic, polled in sorted(POLLED.items(), key=lambda item: -item[1].rate)
    }


# --- The serial timeout -----------------------------------------------------------------


def silence(line: LineSettings, command: Command[object]) -> float:
    """Return the longest silence that the board may measure around a reply, in seconds."""
    size = command.reply_size() + (line.detection is Detection.CRC7)
    return line.seconds(size + 1) + command.max_reply_delay + _MARGIN


def too_slow(line: LineSettings, timeout: float) -> frozenset[Topic]:
    """Return the topics whose replies outlast a serial timeout (seconds, 0: off)."""
    if timeout <= 0:
        return frozenset()
    return frozenset(topic for topic in POLLED if silence(line, POLLED[topic].query) >= timeout)


def survives_a_loss(line: LineSettings, timeout: float, reply_timeout: float) -> bool:
    """True if a lost reply does not cause a serial timeout.

    `reply_timeout` is in seconds, without the transmission time.
    """
    omitted = too_slow(line, timeout)
    queries = [POLLED[topic].query for topic in POLLED if topic not in omitted]
    return timeout <= 0 or max(silence(line, query) for query in queries) + reply_timeout < timeout


# --- The schedule -----------------------------------------------------------------------


class Schedule:
    """Due times of topics. A slow line reduces all rates by the same factor."""

    def __init__(self) -> None:
        self._rates: Mapping[Topic, float] = {}
        self._due: dict[Topic, float] = {}

    def start(self, topic_rates: Mapping[Topic, float], now: float) -> None:
        """Set the polls per second for each topic. All topics are due at `now`."""
        self._rates = topic_rates
        self._due = dict.fromkeys(topic_rates, now)

    def next(self, now: float) -> Topic | None:
        """Return the topic with the earliest due time. `None` if no topic is due."""
        topic = min(self._due, key=self._due.__getitem__, default=None)
        return topic if topic is not None and self._due[topic] <= now else None

    def record_poll(self, topic: Topic, now: float) -> None:
        """Set the next due time, one period after the last due time.

        If the line falls behind, all topics are delayed by the same time, so that no topic starves.
        """
        if topic in self._due:
            self._due[topic] += 1 / self._rates[topic]
            delay = now - _MAXIMUM_LAG - min(self._due.values())
            if delay > 0:
                self._due = {topic: due + delay for topic, due in self._due.items()}

    def seconds_to_next(self, now: float) -> float:
        return max(0.0, min(self._due.values(), default=math.inf) - now)


class Polling:
    """Poll schedule of a board, with keep-alive for its serial timeout."""

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
        """Record and return the topic to poll now. `None` if no topic is due.

        Polls keep the serial `timeout` (seconds, 0: off) from expiring. `careful` omits queries
        that a bit error may turn into a command that drives a motor.
        """
        omitted: Collection[Topic] = too_slow(line, timeout)
        if careful:
            # 86 1F is one bit away from C6 1F, which drives. 87 1F can become C7 1F, which brakes.
            omitted = {*omitted, Raw}
        while topic := self._schedule.next(now):
            self._schedule.record_poll(topic, now)
            if topic not in omitted:
                break
        if topic is None and self._seconds_to_keepalive(now, timeout) == 0:
            topic = _CHEAPEST
        if topic is not None:
            self._polled_at = now
        return topic

    def seconds_to_next(self, now: float, timeout: float) -> float:
        return min(self._schedule.seconds_to_next(now), self._seconds_to_keepalive(now, timeout))

    def _seconds_to_keepalive(self, now: float, timeout: float) -> float:
        if timeout <= 0:
            return math.inf
        return max(0.0, self._polled_at + timeout * _KEEPALIVE_FRACTION - now)
