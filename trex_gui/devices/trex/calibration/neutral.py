"""Where a channel rests, and how still it is there."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, pi, sqrt
from statistics import median

from trex_gui.devices.trex.calibration.problems import Problem, ProblemKind
from trex_gui.devices.trex.calibration.samples import LIMITS, Sample, deviation, runs
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import InputSource

SAMPLING_SECONDS = 1.5
"""How long a channel is sampled: some 75 values of a board that renews them 50 times a second."""

LEAST_SAMPLES = 15
"""A slow line needs longer for as many."""

_SHOWN_LEAST = 0.1
"""Seconds that are said to be left while a sample lacks."""

_JUDGED_FROM = 5
"""Samples from which on it is worth saying that something is wrong."""

_MOST_INVALID = 0.05
"""Share of samples without a signal that is still good: the board bridges 100 ms by itself."""

_MOST_SPIKES = 0.03
"""Share of lone wild values that is still good."""

_SPIKE_LENGTH = 2
"""Samples that a wild pulse makes at most: it may be read twice."""

_BESIDE = 3
"""Samples to each side that a wild one is compared with: more than it lasts."""

_STUCK_SHOWN = 0.3
"""Share of pulses that did not come from which on it is said. Inferred: the estimate from 75
values errs by 0.1, so that a third goes unsaid now and then, and 45 % does not."""

_STUCK_JUDGED_FROM = 2.0
"""Counts of noise (0.8 us) from which on a repeated value can be distinguished from one that is
the same again. A quieter signal hides its lost pulses until 100 ms lack."""

_STUCK_INTERVAL = 0.03
"""Seconds between two values up to which a repeated one can be seen."""

_RANGE_OF_NOISE = 10.0
"""Standard deviations that noise alone never spans: 75 normal values span 4.8, seldom 6.5."""

_DRIFT_OF_NOISE = 6.0
"""Standard deviations of the difference between two medians that noise alone never makes."""

_MEDIAN_ERROR = 1.25
"""Standard deviation of a median of normal values, times the root of their number."""


@dataclass(frozen=True, slots=True)
class Neutral:
    """What was measured of a channel at rest, in counts.

    Attributes:
        value: the median.
        noise: from the lowest to the highest value, lone wild ones left out.
        deviation: standard deviation of the noise.
        drift: how far the last third lies above the first.
        invalid: share of samples without a signal.
        samples: how many there were.
        seconds: from the first to the last.
    """

    source: InputSource
    value: int
    noise: int
    deviation: float
    drift: int
    invalid: float
    samples: int
    seconds: float
    problems: tuple[Problem, ...] = ()

    @property
    def is_complete(self) -> bool:
        """Whether it was sampled for long enough."""
        return self.seconds_left == 0

    @property
    def seconds_left(self) -> float:
        """How much longer it has to be sampled, as far as is known; 0 when it is complete."""
        time_left = max(0.0, SAMPLING_SECONDS - self.seconds)
        if self.samples >= LEAST_SAMPLES:
            return time_left
        interval = self.seconds / (self.samples - 1) if self.samples > 1 else 0.0
        return max(time_left, (LEAST_SAMPLES - self.samples) * interval, _SHOWN_LEAST)

    @property
    def deadband(self) -> int:
        """The least deadband that holds the channel still, in counts."""
        return max(deadband_floor(self.source), self.noise)

    @property
    def noise_text(self) -> str:
        """The noise, to each side, such as `±2.0 µs`."""
        return swing_text(self.noise / 2, self.source)

    @property
    def deadband_reason(self) -> str:
        """Why the deadband is more than the least; empty where it is not."""
        if self.noise <= deadband_floor(self.source):
            return ""
        return f"At rest its noise is {self.noise_text}: the deadband is twice that."


def deadband_floor(source: InputSource) -> int:
    """Counts below which no deadband is proposed: the factory's own, 30 us or 98 mV (inferred)."""
    return DEFAULT_CALIBRATION[source].deadband


def swing_text(counts: float, source: InputSource) -> str:
    """A small swing to both sides, with the decimals that it needs: `±2.0 µs`, `±15 mV`."""
    if source is InputSource.RC:
        return f"±{source.physical(counts):.1f} µs"
    return f"±{1000 * source.physical(counts):.0f} mV"


def measure_neutral(samples: Sequence[Sample], source: InputSource) -> Neutral | None:
    """Judge a channel that should be at rest; `None` before the first sample."""
    if not samples:
        return None
    counts = [sample.count for sample in samples if sample.count is not None]
    total = len(samples)
    invalid = (total - len(counts)) / total
    seconds = samples[-1].time - samples[0].time
    if total >= _JUDGED_FROM and len(counts) < total / 2:
        return Neutral(source, 0, 0, 0.0, 0, invalid, total, seconds, (no_signal(source),))
    if not counts:
        return None
    spread = deviation(counts)
    middle = median(counts)
    quiet, spikes = _without_spikes(counts, max(LIMITS[source].moved, 10 * spread))
    noise = max(quiet) - min(quiet)
    drift = _drift(quiet)
    problems: list[Problem] = []
    if total >= _JUDGED_FROM:
        problems += _movement(quiet, noise, drift, spread, source)
        problems += _jitter(invalid, spikes, total)
        if not problems and noise > LIMITS[source].noisy:
            problems.append(_too_noisy(noise, source))
        if not problems and total >= LEAST_SAMPLES and source is InputSource.RC:
            problems += _stuck(counts, spread, seconds / (total - 1))
    return Neutral(
        source, round(middle), noise, spread, drift, invalid, total, seconds, tuple(problems)
    )


def no_signal(source: InputSource) -> Problem:
    """Return the problem that nothing valid comes in."""
    return Problem(ProblemKind.NO_SIGNAL, source.name)


def _without_spikes(counts: Sequence[int], limit: float) -> tuple[Sequence[int], int]:
    """Leave out wild values that stand alone; return what is left and how many there were.

    Wild is what is far from its neighbours: a stick that drifts is far from its own middle.
    """
    wild = [
        abs(count - median(counts[max(0, index - _BESIDE) : index + _BESIDE + 1])) > limit
        for index, count in enumerate(counts)
    ]
    lone: set[int] = set()
    times = 0
    for start, end in runs(wild):
        if end - start <= _SPIKE_LENGTH:
            lone.update(range(start, end))
            times += end < len(counts)  # the last one may be the begin of a movement
    # Of two values that are far apart each is wild.
    return [count for index, count in enumerate(counts) if index not in lone] or counts, times


def _drift(counts: Sequence[int]) -> int:
    third = len(counts) // 3
    return round(median(counts[-third:]) - median(counts[:third])) if third else 0


def _movement(
    counts: Sequence[int], noise: int, drift: int, spread: float, source: InputSource
) -> list[Problem]:
    limits = LIMITS[source]
    third = max(1, len(counts) // 3)
    drift_limit = _DRIFT_OF_NOISE * _MEDIAN_ERROR * spread * sqrt(2 / third)
    noise_limit = max(limits.moved, _RANGE_OF_NOISE * spread)
    drifts = len(counts) >= LEAST_SAMPLES and abs(drift) > max(limits.drifted, drift_limit)
    is_steady = drifts and _noise_beside(counts, drift) <= noise_limit
    if noise > noise_limit and not is_steady:
        values = source.text(min(counts)), source.text(max(counts))
        return [Problem(ProblemKind.MOVED, source.name, values)]
    if drifts:
        way = "UP" if drift > 0 else "DOWN"
        return [Problem(ProblemKind.MOVED, way, (source.text(abs(drift)),))]
    return []


def _noise_beside(counts: Sequence[int], drift: int) -> float:
    """Return from the lowest to the highest value, beside a drift that goes on all the time."""
    step = drift / (len(counts) - len(counts) // 3)
    level = [count - step * index for index, count in enumerate(counts)]
    return max(level) - min(level)


def _jitter(invalid: float, spikes: int, total: int) -> list[Problem]:
    if invalid > _MOST_INVALID:
        return [lost_pulses(invalid)]
    if spikes > max(1, ceil(_MOST_SPIKES * total)):
        return [Problem(ProblemKind.JITTER, "SPIKES", (spikes, total))]
    return []


def lost_pulses(share: float, *, fatal: bool = True) -> Problem:
    """Return the problem that the signal comes and goes."""
    return Problem(ProblemKind.JITTER, "LOST", (share,), fatal)


def _stuck(counts: Sequence[int], spread: float, interval: float) -> list[Problem]:
    """Say how many pulses lack, though the board repeats the last value for each of them.

    Every value differs from the one before, but for some that are so by chance or were read
    twice. So those count that are the third alike in a row, or more: of a share `p` of equal
    neighbours it is `p * p`.
    """
    if spread < _STUCK_JUDGED_FROM or interval > _STUCK_INTERVAL:
        return []
    triples = zip(counts, counts[1:], counts[2:], strict=False)
    thirds = sum(first == second == third for first, second, third in triples)
    alike = sqrt(thirds / (len(counts) - 2))
    by_chance = 1 / (2 * sqrt(pi) * spread)
    share = (alike - by_chance) / (1 - by_chance)
    if share < _STUCK_SHOWN:
        return []
    return [Problem(ProblemKind.JITTER, "STUCK", (share,), fatal=False)]


def _too_noisy(noise: int, source: InputSource) -> Problem:
    return Problem(ProblemKind.NOISE, source.name, (swing_text(noise / 2, source),))
