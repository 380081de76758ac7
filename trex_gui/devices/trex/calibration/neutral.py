"""Rest position of a channel, and its noise."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from math import ceil, pi, sqrt
from statistics import median

from trex_gui.core.translation import Number
from trex_gui.devices.trex.calibration.problems import CalibrationProblem, ProblemKind
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import InputSource

SAMPLING_SECONDS = 1.5  # about 75 values at 50 updates a second
_LEAST_SAMPLES = 15  # take longer than `SAMPLING_SECONDS` on a slow line
_SHOWN_LEAST = 0.1  # least remaining seconds to show while a sample is missing
_JUDGED_FROM = 5  # least samples to report a problem
_MOST_INVALID = 0.05  # share of samples without a signal; the board bridges 100 ms by itself
_MOST_SPIKES = 0.03  # acceptable share of lone wild values
_SPIKE_LENGTH = 2  # most samples of one wild pulse, which may be read twice
_BESIDE = 3  # neighbours on each side for a comparison, more than a spike lasts

_STUCK_SHOWN = 0.3
"""Least share of lost pulses to report. Inferred: the estimate from 75 values errs by 0.1, so it
sometimes misses a share of a third, but not a share of 45 %."""

_STUCK_JUDGED_FROM = 2.0
"""Least counts of noise (0.8 us) to distinguish a repeated value from an equal new value. A quieter
signal hides its lost pulses until 100 ms are missing."""

_STUCK_INTERVAL = 0.03  # longest interval in seconds that shows repeats
_RANGE_OF_NOISE = 10.0  # standard deviations: 75 normal values span 4.8, seldom 6.5
_DRIFT_OF_NOISE = 6.0  # standard deviations; noise alone never moves a median this far
_MEDIAN_ERROR = 1.25  # deviation of a median of normal values, times the root of their number
_MAD_TO_DEVIATION = 1.4826  # of a normal distribution, for a median absolute deviation of 1
_LEAST_DEVIATION = 1.0  # counts; a converter that rounds to whole counts shows no less

_STILL = 0.75  # share of equal neighbours at standstill; polling may read a value twice


@dataclass(frozen=True, slots=True)
class ChannelSample:
    time: float  # seconds
    count: int | None  # raw count; `None` without a valid signal


@dataclass(frozen=True, slots=True)
class InputLimits:
    """Least movements to report, in counts."""

    moved: int
    drifted: int
    noisy: int


LIMITS = {
    InputSource.RC: InputLimits(moved=25, drifted=12, noisy=312),  # 10, 5 and 125 us
    InputSource.ANALOG: InputLimits(moved=8, drifted=4, noisy=128),  # 39, 20 and 626 mV
}
"""Inferred: a hand moves a stick further, and a spring holds it closer."""


@dataclass(frozen=True, slots=True)
class Neutral:
    """A channel at rest, in counts."""

    source: InputSource
    value: int  # the median
    noise: int  # from the lowest to the highest value, without lone wild values
    deviation: float  # standard deviation of the noise
    invalid: float  # share of samples without a signal
    samples: int
    seconds: float  # from the first sample to the last
    problems: tuple[CalibrationProblem, ...]

    @property
    def seconds_left(self) -> float:
        """Estimated remaining sampling time. 0 when the measurement is complete."""
        time_left = max(0.0, SAMPLING_SECONDS - self.seconds)
        if self.samples >= _LEAST_SAMPLES:
            return time_left
        interval = self.seconds / (self.samples - 1) if self.samples > 1 else 0.0
        return max(time_left, (_LEAST_SAMPLES - self.samples) * interval, _SHOWN_LEAST)

    @property
    def deadband(self) -> int:
        """Least deadband that hides the noise, in counts."""
        return max(deadband_floor(self.source), self.noise)

    @property
    def noise_text(self) -> str:
        return swing_text(self.noise / 2, self.source)


def deadband_floor(source: InputSource) -> int:
    """Return the least deadband to propose: 30 us or 98 mV (inferred)."""
    return DEFAULT_CALIBRATION[source].deadband


def swing_text(counts: float, source: InputSource) -> str:
    """Return a swing as text, `±2.0 µs` or `±15 mV`."""
    if source is InputSource.RC:
        return f"±{Number(source.physical(counts)):.1f} µs"
    return f"±{1000 * source.physical(counts):.0f} mV"


def no_signal(source: InputSource) -> CalibrationProblem:
    return CalibrationProblem(ProblemKind.NO_SIGNAL, source.name)


def lost_pulses(share: float, *, fatal: bool = True) -> CalibrationProblem:
    return CalibrationProblem(ProblemKind.JITTER, "LOST", (share,), fatal)


def measure_neutral(samples: Sequence[ChannelSample], source: InputSource) -> Neutral | None:
    """Measure a channel at rest. `None` before the first valid sample."""
    if not samples:
        return None
    counts = [sample.count for sample in samples if sample.count is not None]
    total = len(samples)
    invalid = (total - len(counts)) / total
    seconds = samples[-1].time - samples[0].time
    if total >= _JUDGED_FROM and len(counts) < total / 2:
        return Neutral(source, 0, 0, 0.0, invalid, total, seconds, (no_signal(source),))
    if not counts:
        return None
    spread = _deviation(counts)
    quiet, spikes = _without_spikes(counts, max(LIMITS[source].moved, 10 * spread))
    noise = max(quiet) - min(quiet)
    problems: tuple[CalibrationProblem, ...] = ()
    if total >= _JUDGED_FROM:
        found = _movement(quiet, noise, spread, source), _jitter(invalid, spikes, total)
        problems = tuple(problem for problem in found if problem is not None)
        if not problems and noise > LIMITS[source].noisy:
            problems = (
                CalibrationProblem(
                    ProblemKind.NOISE, source.name, (swing_text(noise / 2, source),)
                ),
            )
        if not problems and total >= _LEAST_SAMPLES and source is InputSource.RC:
            problems = _stuck(counts, spread, seconds / (total - 1))
    return Neutral(source, round(median(counts)), noise, spread, invalid, total, seconds, problems)


def _deviation(counts: Sequence[int]) -> float:
    """Return the standard deviation of the noise.

    Medians of the differences between neighbours exclude a steady movement and a few wild values.
    """
    steps = [b - a for a, b in pairwise(counts)]
    moving = [step for step in steps if step]
    if not steps or len(moving) <= (1 - _STILL) * len(steps):
        return _LEAST_DEVIATION
    trend = median(moving)
    spread = min(median(abs(step - way) for step in moving) for way in (0, trend))
    return max(_LEAST_DEVIATION, _MAD_TO_DEVIATION * spread / 2**0.5)


def _without_spikes(counts: Sequence[int], limit: float) -> tuple[Sequence[int], int]:
    """Remove lone wild values. Return the other values and the number of spikes.

    Values are compared with their neighbours, because a drifting stick is far from its own median.
    """
    wild = [
        abs(count - median(counts[max(0, index - _BESIDE) : index + _BESIDE + 1])) > limit
        for index, count in enumerate(counts)
    ]
    lone: set[int] = set()
    spikes = 0
    for is_wild, indices in groupby(range(len(counts)), key=wild.__getitem__):
        run = list(indices)
        if is_wild and len(run) <= _SPIKE_LENGTH:
            lone.update(run)
            spikes += run[-1] + 1 < len(counts)  # the last sample may start a movement
    # Of only two values, far apart, both are wild.
    return [count for index, count in enumerate(counts) if index not in lone] or counts, spikes


def _movement(
    counts: Sequence[int], noise: int, spread: float, source: InputSource
) -> CalibrationProblem | None:
    limits = LIMITS[source]
    third = len(counts) // 3
    drift = round(median(counts[-third:]) - median(counts[:third])) if third else 0
    drift_limit = _DRIFT_OF_NOISE * _MEDIAN_ERROR * spread * sqrt(2 / max(1, third))
    noise_limit = max(limits.moved, _RANGE_OF_NOISE * spread)
    drifts = len(counts) >= _LEAST_SAMPLES and abs(drift) > max(limits.drifted, drift_limit)
    is_steady = drifts and _noise_beside(counts, drift) <= noise_limit
    if noise > noise_limit and not is_steady:
        ends = source.text(min(counts)), source.text(max(counts))
        return CalibrationProblem(ProblemKind.MOVED, source.name, ends)
    if drifts:
        return CalibrationProblem(
            ProblemKind.MOVED, "UP" if drift > 0 else "DOWN", (source.text(abs(drift)),)
        )
    return None


def _noise_beside(counts: Sequence[int], drift: int) -> float:
    """Return the range of the values without a steady drift."""
    step = drift / (len(counts) - len(counts) // 3)
    level = [count - step * index for index, count in enumerate(counts)]
    return max(level) - min(level)


def _jitter(invalid: float, spikes: int, total: int) -> CalibrationProblem | None:
    if invalid > _MOST_INVALID:
        return lost_pulses(invalid)
    if spikes > max(1, ceil(_MOST_SPIKES * total)):
        return CalibrationProblem(ProblemKind.JITTER, "SPIKES", (spikes, total))
    return None


def _stuck(counts: Sequence[int], spread: float, interval: float) -> tuple[CalibrationProblem, ...]:
    """Estimate the share of lost pulses, for which the board repeats the last value.

    Two neighbours may be equal by chance or by a double read. So only the third and later equal
    values in a row count. If the share of equal neighbours is `p`, the share of these values is
    `p * p`.
    """
    if spread < _STUCK_JUDGED_FROM or interval > _STUCK_INTERVAL:
        return ()
    triples = zip(counts, counts[1:], counts[2:], strict=False)
    thirds = sum(first == second == third for first, second, third in triples)
    alike = sqrt(thirds / (len(counts) - 2))
    by_chance = 1 / (2 * sqrt(pi) * spread)
    share = (alike - by_chance) / (1 - by_chance)
    if share < _STUCK_SHOWN:
        return ()
    return (CalibrationProblem(ProblemKind.JITTER, "STUCK", (share,), fatal=False),)
