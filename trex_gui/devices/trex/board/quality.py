"""Quality of the line to a board, measured from recent transactions."""

import math
from collections import deque
from dataclasses import dataclass

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.telemetry import Currents
from trex_gui.devices.trex.driving.board_reasons import NOISE_COUNTS

_MINIMUM_SECONDS = 10.0  # minimum length of a measurement

# Minimum number of transactions in a measurement. They take 3 s at 19200 baud. A board counts as
# silent after three failures. These are a smaller fraction of this number than `_NOISY`.
_MINIMUM_TRANSACTIONS = 500

_INTERVAL = 2.0  # minimum seconds between two results, so that the text remains readable

# A line that damages 1 % of the bytes loses 1.3 % of the transactions (measured with the simulated
# board), because most damaged replies without CRC look valid. Such a line damages one in 25
# motor commands of four bytes. A single wrong bit can turn one command into another.
_NOISY = 0.01  # fraction of failures at which a line is noisy
_GOOD = 0.005  # fraction of failures below which a noisy line is good again

_STRAY_BYTES = 10  # unexpected bytes that count as one failure: the longest reply without CRC

_DOUBTFUL_FOR = 5.0  # seconds after a failure during which replies without CRC are doubtful


@dataclass(frozen=True, slots=True)
class _Mark:
    """Counters at one moment."""

    time: float
    requests: int
    lost: int  # missing and corrupted replies
    stray: int  # unexpected bytes


class ConnectionQuality:
    def __init__(self) -> None:
        self.is_noisy: bool | None = None  # `None` until the first result
        self.lost = 0.0  # fraction of transactions with a missing or corrupted reply
        self.seconds = 0.0  # length of the measurement, initially less than 10
        self.rate = 0.0  # transactions per second; 0 if unknown
        self._marks = deque[_Mark]()
        self._failures = 0  # total number of failures, as of the last check
        self._failed_at = -math.inf

    def reset(self) -> bool:
        """Clear the measurement. Return True if it had a result."""
        changed = self.is_noisy is not None
        self.is_noisy, self.lost, self.seconds, self.rate = None, 0.0, 0.0, 0.0
        self._marks.clear()
        return changed

    def update(self, time: float, counters: Counters) -> bool:
        """Update the measurement. Return True if the result changed.

        `time` is on the session's clock, in seconds.
        """
        marks = self._marks
        if marks and time - marks[-1].time < _INTERVAL:
            return False
        lost = counters.missing + counters.corrupted
        newest = _Mark(time, counters.requests, lost, counters.unsolicited)
        marks.append(newest)
        while (
            len(marks) > 2
            and newest.time - marks[1].time >= _MINIMUM_SECONDS
            and newest.requests - marks[1].requests >= _MINIMUM_TRANSACTIONS
        ):
            marks.popleft()
        requests = newest.requests - marks[0].requests
        self.seconds = time - marks[0].time
        self.rate = requests / self.seconds if self.seconds else 0.0
        if requests < _MINIMUM_TRANSACTIONS:
            return False
        before = self.is_noisy, round(self.lost, 3)
        self.lost = (newest.lost - marks[0].lost) / requests
        disturbed = (newest.stray - marks[0].stray) / _STRAY_BYTES / requests
        failed = max(self.lost, disturbed)
        self.is_noisy = failed >= (_GOOD if self.is_noisy else _NOISY)
        return (self.is_noisy, round(self.lost, 3)) != before

    def has_failed_lately(self, time: float, counters: Counters) -> bool:
        """Record new failures. Return True if recent readings may be corrupted. `time` is in s."""
        failures = counters.missing + counters.corrupted
        if failures > self._failures:
            self._failed_at = time
        self._failures = failures
        return time - self._failed_at < _DOUBTFUL_FOR


class SpikeFilter:
    """Filter for jumps of the currents that the next sample does not confirm."""

    def __init__(self) -> None:
        self._last: Currents | None = None
        self._held: Currents | None = None  # sample that waits for confirmation

    def passed(self, sample: Currents, *, is_doubtful: bool) -> list[Currents]:
        """Return the samples to show. A doubtful jump is held until the next sample."""
        last, held = self._last, self._held
        confirmed = [held] if held and last and _is_between(held, last, sample) else []
        last = held if confirmed else last
        if is_doubtful and last is not None and not _is_between(sample, last, last):
            self._last, self._held = last, sample
            return confirmed
        self._last, self._held = sample, None
        return [*confirmed, sample]


def _is_between(sample: Currents, first: Currents, second: Currents) -> bool:
    return all(
        min(limits) - NOISE_COUNTS <= count <= max(limits) + NOISE_COUNTS
        for count, *limits in zip(sample.counts, first.counts, second.counts, strict=True)
    )


def quality_text(quality: ConnectionQuality) -> str:
    """Describe the quality, with the percentage of answered requests."""
    if quality.is_noisy is None:
        return tr("being measured …")
    text = tr("noisy: {0:.1f} % of the requests in the last {1:.0f} s were answered")
    if not quality.is_noisy:
        text = tr("good: {0:.1f} % of the requests in the last {1:.0f} s were answered")
    return text.format(Number(100 * (1 - quality.lost)), quality.seconds)
