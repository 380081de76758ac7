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
_MIN_SAMPLES = 15  # on a slow line, these take longer than `SAMPLING_SECONDS`
_MIN_SECONDS_LEFT = 0.1  # minimum remaining seconds to show while samples are missing
_MIN_JUDGED = 5  # samples; with fewer, no problem is reported
_MAX_INVALID = 0.05  # fraction of samples without a signal; the board itself bridges 100 ms
_MAX_SPIKES = 0.03  # fraction of lone wild values
_SPIKE_LENGTH = 2  # maximum samples of a wild pulse, since a pulse may be read twice
_NEIGHBOURS = 3  # on each side of a compared value; more than `_SPIKE_LENGTH`

_MIN_STUCK = 0.3
"""Minimum fraction of lost pulses to report. Inferred: the estimate from 75 values errs by 0.1. A
loss of one third is sometimes missed, but not a loss of 45 %."""

_STUCK_MIN_NOISE = 2.0
"""Minimum noise in counts (0.8 us). With less noise, a repeated value looks like an equal new
value, and lost pulses are hidden until 100 ms are missing."""

_STUCK_MAX_INTERVAL = 0.03  # seconds between samples; a longer interval hides repeats
_RANGE_OF_NOISE = 10.0  # standard deviations; 75 normally distributed values span 4.8, rarely 6.5
_DRIFT_OF_NOISE = 6.0  # standard deviations; noise alone never moves a median this far
_MEDIAN_ERROR = 1.25  # standard error of the median of n normal values, times √n
_MAD_TO_DEVIATION = 1.4826  # ratio for a normal distribution (MAD: median absolute deviation)
_MIN_DEVIATION = 1.0  # counts; a converter that rounds to whole counts cannot show less

_STILL = 0.75  # minimum fraction of equal neighbours at standstill; a poll may repeat a value


@dataclass(frozen=True, slots=True)
class ChannelSample:
    time: float  # seconds
    count: int | None  # raw count; `None` without a valid signal


@dataclass(frozen=True, slots=True)
class InputLimits:
    """Minimum movements to report, in counts."""

    moved: int
    drifted: int
    noisy: int


LIMITS = {
    InputSource.RC: InputLimits(moved=25, drifted=12, noisy=312),  # 10, 5 and 125 us
    InputSource.ANALOG: InputLimits(moved=8, drifted=4, noisy=128),  # 39, 20 and 626 mV
}
"""Inferred: a hand moves a stick further than this. A spring returns the stick closer to rest."""


@dataclass(frozen=True, slots=True)
class Neutral:
    """Measurement of a channel at rest, in counts."""

    source: InputSource
    value: int  # the median
    noise: int  # range of the values, without lone wild values
    deviation: float  # standard deviation of the noise
    invalid: float  # fraction of samples without a signal
    samples: int
    seconds: float  # from the first sample to the last
    problems: tuple[CalibrationProblem, ...]

    @property
    def seconds_left(self) -> float:
        """Estimated remaining sampling time. It is 0 when the measurement is complete."""
        time_left = max(0.0, SAMPLING_SECONDS - self.seconds)
        if self.samples >= _MIN_SAMPLES:
            return time_left
        interval = self.seconds / (self.samples - 1) if self.samples > 1 else 0.0
        return max(time_left, (_MIN_SAMPLES - self.samples) * interval, _MIN_SECONDS_LEFT)

    @property
    def deadband(self) -> int:
        """Smallest deadband that hides the noise, in counts."""
        return max(deadband_floor(self.source), self.noise)

    @property
    def noise_text(self) -> str:
        return swing_text(self.noise / 2, self.source)


def deadband_floor(source: InputSource) -> int:
    """Return the smallest deadband to propose: 30 us or 98 mV (inferred)."""
    return DEFAULT_CALIBRATION[source].deadband


def swing_text(counts: float, source: InputSource) -> str:
    """Return a swing as text, such as `±2.0 µs` or `±15 mV`."""
    if source is InputSource.RC:
        return f"±{Number(source.physical(counts)):.1f} µs"
    return f"±{1000 * source.physical(counts):.0f} mV"


def no_signal(source: InputSource) -> CalibrationProblem:
    return CalibrationProblem(ProblemKind.NO_SIGNAL, source.name)


def lost_pulses(fraction: float, *, fatal: bool = True) -> CalibrationProblem:
    return CalibrationProblem(ProblemKind.JITTER, "LOST", (fraction,), fatal)


def measure_neutral(samples: Sequence[ChannelSample], source: InputSource) -> Neutral | None:
    """Measure a channel at rest. `None` for fewer than `_MIN_JUDGED` samples, all invalid."""
    if not samples:
        return None
    counts = [sample.count for sample in samples if sample.count is not None]
    total = len(samples)
    invalid = (total - len(counts)) / total
    seconds = samples[-1].time - samples[0].time
    if total >= _MIN_JUDGED and len(counts) < total / 2:
        return Neutral(source, 0, 0, 0.0, invalid, total, seconds, (no_signal(source),))
    if not counts:
        return None
    spread = _deviation(counts)
    quiet, spikes = _without_spikes(counts, max(LIMITS[source].moved, 10 * spread))
    noise = max(quiet) - min(quiet)
    problems: tuple[CalibrationProblem, ...] = ()
    if total >= _MIN_JUDGED:
        candidates = _movement(quiet, noise, spread, source), _jitter(invalid, spikes, total)
        problems = tuple(problem for problem in candidates if problem is not None)
        if not problems and noise > LIMITS[source].noisy:
            swing = swing_text(noise / 2, source)
            problems = (CalibrationProblem(ProblemKind.NOISE, source.name, (swing,)),)
        if not problems and total >= _MIN_SAMPLES and source is InputSource.RC:
            problems = _stuck(counts, spread, seconds / (total - 1))
    return Neutral(source, round(median(counts)), noise, spread, invalid, total, seconds, problems)


def _deviation(counts: Sequence[int]) -> float:
    """Return the standard deviation of the noise.

    Medians of the differences between neighbours exclude a steady movement and a few wild values.
    """
    steps = [b - a for a, b in pairwise(counts)]
    moving = [step for step in steps if step]
    if not steps or len(moving) <= (1 - _STILL) * len(steps):
        return _MIN_DEVIATION
    trend = median(moving)
    spread = min(median(abs(step - offset) for step in moving) for offset in (0, trend))
    return max(_MIN_DEVIATION, _MAD_TO_DEVIATION * spread / 2**0.5)


def _without_spikes(counts: Sequence[int], limit: float) -> tuple[Sequence[int], int]:
    """Remove lone wild values. Return the other values and the number of spikes.

    Values are compared with their neighbours, because a drifting stick is far from its own median.
    """
    wild = [
        abs(count - median(counts[max(0, index - _NEIGHBOURS) : index + _NEIGHBOURS + 1])) > limit
        for index, count in enumerate(counts)
    ]
    lone: set[int] = set()
    spikes = 0
    for is_wild, indices in groupby(range(len(counts)), key=wild.__getitem__):
        run = list(indices)
        if is_wild and len(run) <= _SPIKE_LENGTH:
            lone.update(run)
            spikes += run[-1] + 1 < len(counts)  # the last sample may start a movement
    # If there are only two values and they differ greatly, both are wild, and both are returned.
    return [count for index, count in enumerate(counts) if index not in lone] or counts, spikes


def _movement(
    counts: Sequence[int], noise: int, spread: float, source: InputSource
) -> CalibrationProblem | None:
    limits = LIMITS[source]
    third = len(counts) // 3
    drift = round(median(counts[-third:]) - median(counts[:third])) if third else 0
    drift_limit = _DRIFT_OF_NOISE * _MEDIAN_ERROR * spread * sqrt(2 / max(1, third))
    noise_limit = max(limits.moved, _RANGE_OF_NOISE * spread)
    drifts = len(counts) >= _MIN_SAMPLES and abs(drift) > max(limits.drifted, drift_limit)
    is_steady = drifts and _noise_without_drift(counts, drift) <= noise_limit
    if noise > noise_limit and not is_steady:
        extremes = source.text(min(counts)), source.text(max(counts))
        return CalibrationProblem(ProblemKind.MOVED, source.name, extremes)
    if drifts:
        direction = "UP" if drift > 0 else "DOWN"
        return CalibrationProblem(ProblemKind.MOVED, direction, (source.text(abs(drift)),))
    return None


def _noise_without_drift(counts: Sequence[int], drift: int) -> float:
    """Return the range of the values after a steady drift is removed."""
    step = drift / (len(counts) - len(counts) // 3)
    corrected = [count - step * index for index, count in enumerate(counts)]
    return max(corrected) - min(corrected)


def _jitter(invalid: float, spikes: int, total: int) -> CalibrationProblem | None:
    if invalid > _MAX_INVALID:
        return lost_pulses(invalid)
    if spikes > max(1, ceil(_MAX_SPIKES * total)):
        return CalibrationProblem(ProblemKind.JITTER, "SPIKES", (spikes, total))
    return None


def _stuck(counts: Sequence[int], spread: float, interval: float) -> tuple[CalibrationProblem, ...]:
    """Report a high fraction of lost pulses.

    The board repeats the last value for a lost pulse. Two neighbours may also be equal by chance,
    or because a value was read twice. So only the third and later equal values in a row count. If
    the fraction of equal neighbours is `p`, the fraction of these values is `p * p`.
    """
    if spread < _STUCK_MIN_NOISE or interval > _STUCK_MAX_INTERVAL:
        return ()
    triples = zip(counts, counts[1:], counts[2:], strict=False)
    thirds = sum(first == second == third for first, second, third in triples)
    equal_fraction = sqrt(thirds / (len(counts) - 2))
    by_chance = 1 / (2 * sqrt(pi) * spread)
    lost_fraction = (equal_fraction - by_chance) / (1 - by_chance)
    if lost_fraction < _MIN_STUCK:
        return ()
    return (CalibrationProblem(ProblemKind.JITTER, "STUCK", (lost_fraction,), fatal=False),)
